// The search of the index: every word must occur in the study's title, name, problem, tags, captions or remarks. A pressed tag is one
// more condition. What is not found is hidden in the index and below it.
function index() {
  const nav = document.querySelector("nav");
  const [search, count] = [nav.querySelector("[type=search]"), nav.querySelector("output")];
  const tags = [...nav.querySelectorAll("[data-tag]")];
  const entries = [...nav.querySelectorAll("li")].map(entry => {
    const section = document.getElementById(entry.querySelector("a").hash.slice(1));
    const texts = [entry, ...section.querySelectorAll("h3, p, figcaption, dl")].map(element => element.textContent);
    return { entry, section, words: texts.join(" ").toLowerCase(), tags: entry.dataset.tags.split(" ") };
  });
  const groups = [...document.querySelectorAll(".group")];

  function choose() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const pressed = tags.filter(tag => tag.getAttribute("aria-pressed") === "true").map(tag => tag.dataset.tag);
    let found = 0;
    for (const own of entries) {
      const has = words.every(word => own.words.includes(word)) && pressed.every(tag => own.tags.includes(tag));
      own.entry.hidden = own.section.hidden = !has;
      found += has;
    }
    for (const group of groups) group.hidden = !group.querySelector("li:not([hidden]), section.study:not([hidden])");
    count.textContent = found === entries.length ? `${found} studies` : `${found} of ${entries.length} studies`;
  }

  search.addEventListener("input", choose);
  for (const tag of tags) tag.addEventListener("click", () => {
    tag.setAttribute("aria-pressed", String(tag.getAttribute("aria-pressed") !== "true"));
    choose();
  });
  choose();
}

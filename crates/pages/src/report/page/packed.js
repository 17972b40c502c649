// Figures and tables stand in the page compressed, and are unpacked when they are shown.
async function unpack(script) {
  const text = atob(script.textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).arrayBuffer();
}

// Replaces the script of an element by its HTML, once.
async function show(element) {
  const script = element.querySelector(":scope > script");
  if (!script || element.dataset.begun) return;
  element.dataset.begun = "yes";
  element.innerHTML = new TextDecoder().decode(await unpack(script));
  element.querySelectorAll(".hover").forEach(arrows);
}

// What a part shows when it is opened.
async function open(part) {
  for (const own of part.querySelectorAll(".packed")) await show(own);
  const results = part.querySelector(".results");
  if (!results || results.dataset.begun) return;
  results.dataset.begun = "yes";
  await table(results);
}

// Figures are drawn shortly before they come into view, parts when they are opened; for printing everything at once.
function parts() {
  const drawings = [...document.querySelectorAll(".drawing")];
  const near = entries => entries.filter(entry => entry.isIntersecting).forEach(entry => {
    seen.unobserve(entry.target);
    show(entry.target);
  });
  const seen = new IntersectionObserver(near, { rootMargin: "800px" });
  drawings.forEach(drawing => seen.observe(drawing));
  for (const part of document.querySelectorAll(".part")) {
    part.addEventListener("toggle", () => part.open && open(part));
    if (part.open) open(part);
  }
  document.querySelector(".print").addEventListener("click", async () => {
    await Promise.all(drawings.map(show));
    print();
  });
}

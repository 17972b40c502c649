// The title of a point, shown at once, also to those who come by keyboard.
function tips() {
  const tip = document.createElement("div");
  tip.id = "tip";
  tip.hidden = true;
  document.body.append(tip);
  const show = event => {
    const point = event.target.closest?.(".hover circle");
    tip.hidden = !point;
    if (!point) return;
    tip.textContent = point.getAttribute("aria-label");
    const place = point.getBoundingClientRect();
    tip.style.left = `${Math.min(place.right + 8, innerWidth - 320)}px`;
    tip.style.top = `${place.bottom + 8}px`;
  };
  document.addEventListener("mouseover", show);
  document.addEventListener("focusin", show);
}

// One stop of the tab key for a figure, the arrows from point to point.
function arrows(group) {
  const points = [...group.children];
  points.forEach((point, i) => point.setAttribute("tabindex", i ? -1 : 0));
  group.addEventListener("keydown", event => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const to = points[points.indexOf(document.activeElement) + step];
    if (to) { event.preventDefault(); to.focus(); }
  });
}

tips();
parts();
if (document.querySelector("nav")) index();

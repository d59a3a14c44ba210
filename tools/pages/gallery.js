"use strict";
// The page of `adit eval --gallery`: which frames and answers are shown, in which order, and which are large.
const $ = id => document.getElementById(id);
const list = $("cards"), cards = [...list.children];
const chief = $("chief"), set = $("set"), which = $("which");
const boxes = [...document.querySelectorAll("input[name=show]")];
const rank = { miss: 0, answered_none: 0, refused_open: 1, not_counted: 2, refused_none: 3, hit: 4 };
const kind = verdict => rank[verdict] < 2 ? "wrong" : rank[verdict] > 2 ? "right" : "other";

function order() {
  const v = "v" + chief.value, e = "e" + chief.value;
  cards.sort((a, b) => rank[a.dataset[v]] - rank[b.dataset[v]] || b.dataset[e] - a.dataset[e]);
  list.append(...cards);
  filter();
}
function filter() {
  let shown = 0;
  for (const card of cards) {
    const off = set.value && card.dataset.set !== set.value ||
      which.value && kind(card.dataset["v" + chief.value]) !== which.value;
    card.classList.toggle("off", Boolean(off));
    if (!off) ++shown;
  }
  $("count").textContent = shown + " of " + cards.length + " frames";
}
function show() {
  for (const box of boxes)
    for (const mark of document.querySelectorAll(".m" + box.value)) mark.classList.toggle("off", !box.checked);
}
function enlarge(card, large) {
  card.classList.toggle("large", large);
  card.querySelector("button").setAttribute("aria-expanded", String(large));
}
/// To the next frame that is shown, or the previous one; from the first on where none has the focus.
function step(by) {
  const shown = cards.filter(card => !card.classList.contains("off"));
  const now = shown.indexOf(document.activeElement.closest(".card"));
  const card = shown[now < 0 ? 0 : Math.max(0, Math.min(shown.length - 1, now + by))];
  if (!card) return;
  card.querySelector("button").focus({ preventScroll: true });
  card.scrollIntoView({ block: "nearest" });
}

for (const box of boxes) box.addEventListener("change", show);
chief.addEventListener("change", () => {
  const box = boxes.find(b => b.value === chief.value);
  if (!box.checked) { box.checked = true; show(); }
  order();
});
set.addEventListener("change", filter);
which.addEventListener("change", filter);
list.addEventListener("click", event => {
  const button = event.target.closest(".card > button");
  if (button) enlarge(button.parentElement, !button.parentElement.classList.contains("large"));
});
document.addEventListener("keydown", event => {
  if (/INPUT|SELECT/.test(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "n") step(1);
  else if (event.key === "p") step(-1);
  else if (event.key === "Escape") cards.forEach(card => enlarge(card, false));
  else return;
  event.preventDefault();
});
show();
filter();

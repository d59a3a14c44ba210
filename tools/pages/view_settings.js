// Settings, changed while it runs. Follows view_plan.js in one script.
function holdSettings(hold) {
  for (const input of document.querySelectorAll(".field input, .field select")) input.disabled = hold;
}
const fields = new Map();  // by "section.name"
async function askSettings() {
  const seen = settingsSeen = state.settings;
  try {
    const sections = await (await fetch("settings")).json();
    if (fields.size) {  // somebody else may have changed them
      for (const { section, fields: now } of sections)
        for (const { name, value } of now) fields.get(section + "." + name)?.take(value);
      return;
    }
    $("flown").hidden = !state.has_plan;
    $("settings-section").hidden = false;
    $("settings").replaceChildren(...sections.map(({ section, fields }, i) => {
      const part = document.createElement("details"), head = document.createElement("summary"), grid = document.createElement("div");
      part.open = i === 0;
      head.textContent = section;
      grid.className = "fields";
      grid.append(...fields.map(field => fieldOf(section, field)));
      part.append(head, grid);
      return part;
    }));
  } catch (error) {
    if (settingsSeen === seen) settingsSeen = null;  // the next look asks again
  }
}
function fieldOf(section, field) {
  const box = document.createElement("div"), label = document.createElement("label"), note = document.createElement("small");
  const id = section + "." + field.name, input = document.createElement(field.choices.length ? "select" : "input");
  box.className = "field";
  input.id = id;
  label.htmlFor = id;
  label.textContent = field.name + (field.unit ? `, ${field.unit}` : "");
  note.id = id + "-note";
  note.textContent = field.meaning + (field.choices.length ? "" : ` ${field.minimum} to ${field.maximum}.`);
  input.setAttribute("aria-describedby", note.id);
  if (field.choices.length) input.append(...field.choices.map(choice => new Option(choice, choice)));
  else { input.type = "text"; input.inputMode = "decimal"; }
  input.value = field.value;
  const mark = () => box.classList.toggle("changed", input.value !== field.default);
  mark();
  fields.set(id, { take(value) {
    if (input.value === field.value) input.value = value;  // what is being typed stays
    field.value = value;
    mark();
  } });
  input.onchange = async () => {
    const response = await fetch("settings", { method: "POST", body: JSON.stringify({ [id]: input.value }) });
    const text = (await response.text()).trim();
    $("said").textContent = response.ok ? `${id} is ${input.value}` : text;
    $("said").className = response.ok ? "good" : "bad";
    if (response.ok) field.value = input.value; else input.value = field.value;
    mark();
  };
  box.append(label, input, note);
  return box;
}
$("only").onchange = () => {
  for (const box of document.querySelectorAll(".field")) box.hidden = $("only").checked && !box.classList.contains("changed");
  for (const part of document.querySelectorAll("#settings details"))
    part.hidden = $("only").checked && !part.querySelector(".field.changed");
};

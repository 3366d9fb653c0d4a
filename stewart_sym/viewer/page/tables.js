// Tables of numbers: leg quantities at the clock's time, and their peaks. They contain the drawn values as text.

import { DOUBTFUL, EXCEEDED } from "./quantities.js";

function cell(row, text, tag = "td") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (tag === "th") made.scope = row.parentElement?.tagName === "THEAD" ? "col" : "row";
  row.append(made);
  return made;
}

// A table of six legs with columns { head, text(i, leg) }, which return text and the status of a limit. Returns the
// function that fills it for a sample.
export function legTable(table, columns) {
  const top = table.createTHead().insertRow();
  for (const text of ["leg", ...columns.map(({ head }) => head)]) cell(top, text, "th");
  const body = table.createTBody();
  const cells = [];
  for (let leg = 0; leg < 6; leg++) {
    const row = body.insertRow();
    cell(row, String(leg + 1), "th");
    cells.push(columns.map(() => cell(row, "")));
  }
  return (index) => {
    for (let leg = 0; leg < 6; leg++)
      columns.forEach(({ text }, k) => {
        const { words, verdict = 0 } = text(index, leg);
        const at = cells[leg][k];
        const doubtful = DOUBTFUL.includes(verdict);
        const said = doubtful ? `${words} ?` : words;
        if (at.textContent !== said) at.textContent = said;
        at.classList.toggle("beyond", verdict === EXCEEDED);
        at.classList.toggle("doubtful", doubtful);
      });
  };
}

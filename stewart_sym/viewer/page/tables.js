// Tables of numbers: of the legs at the clock's instant, and their peaks. What is drawn can be read here.

import { shown } from "./numbers.js";

function cell(row, text, tag = "td") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (tag === "th") made.scope = row.parentElement?.tagName === "THEAD" ? "col" : "row";
  row.append(made);
  return made;
}

// A table of six legs whose columns are { head, values(i, leg) }; returns what fills it for an instant.
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
        const { words, warn } = text(index, leg);
        const at = cells[leg][k];
        if (at.textContent !== words) at.textContent = words;
        at.classList.toggle("beyond", Boolean(warn));
      });
  };
}

// Instant of the largest magnitude of each leg in a column of six values an instant.
export function peaks(column) {
  return Array.from({ length: 6 }, (_, leg) => {
    let [best, most] = [0, -1];
    for (let i = leg; i < column.length; i += 6) {
      const value = Math.abs(column[i]);
      if (value > most) [best, most] = [(i - leg) / 6, value];
    }
    return best;
  });
}

export function words(value, unit, digits = 5) {
  return Number.isFinite(value) ? `${shown(value, digits)} ${unit}` : "\u2013";
}

// A report: its theme, and tables that are sorted by a click on a heading, first ascending, then descending.

const dark = matchMedia("(prefers-color-scheme: dark)");
const choose = () => (document.documentElement.dataset.theme = dark.matches ? "dark" : "light");
dark.addEventListener("change", choose);
choose();

function valueOf(row, column) {
  const cell = row.cells[column];
  return cell.dataset.value === undefined ? cell.textContent : Number(cell.dataset.value);
}

function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (typeof a === typeof b) return a.localeCompare(b);
  return typeof a === "number" ? -1 : 1;
}

for (const table of document.querySelectorAll("table.sorts"))
  for (const head of table.tHead.rows[0].cells) {
    // Words are left-aligned with their heading, numbers right-aligned.
    const first = table.tBodies[0].rows[0]?.cells[head.cellIndex];
    head.classList.toggle("words", Boolean(first?.classList.contains("words")));
    head.querySelector("button").addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const each of table.tHead.rows[0].cells) each.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => (down ? -1 : 1) * compare(valueOf(a, head.cellIndex), valueOf(b, head.cellIndex)));
      table.tBodies[0].append(...rows);
    });
  }

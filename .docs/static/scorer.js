/* Order of search results: pages that explain a term come before definitions, notebooks, and the changelog. */
const LAST = /^(?:glossary|changelog|theory\/derivation)/;
var Scorer = {
  score: ([page, , , , score]) => (LAST.test(page) ? 1 : score),
  // Names of the Python package after pages about the same term. The other numbers are those of Sphinx.
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 0, 1: 0, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};

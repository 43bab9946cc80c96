#pragma once

namespace abflat::cli {

/// Everything before the title of the page.
constexpr const char* kBatchPageHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>abflat batch</title>
<style>
  :root { --text: #1b2430; --quiet: #5b6675; --page: #f5f7fa; --card: #fff; --line: #dde2e9;
          --link: #0058a8; --good: #1a7f37; --bad: #b3261e; --picture: #fff; }
  @media (prefers-color-scheme: dark) {
    :root { --text: #e4e9f0; --quiet: #9aa6b6; --page: #12161c; --card: #1a2029; --line: #303947;
            --link: #79b8ff; --good: #56d364; --bad: #ff8a80; --picture: #eef1f5; } }
  * { box-sizing: border-box; }
  body { margin: 0 auto; max-width: 1400px; padding: 1.5rem 1rem 4rem; color: var(--text);
         background: var(--page);
         font: 15px/1.45 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
  h1 { font-size: 1.4rem; line-height: 1.25; margin: 0 0 .2rem; }
  p { color: var(--quiet); margin: 0 0 1rem; }
  a { color: var(--link); overflow-wrap: anywhere; }
  dl { display: flex; flex-wrap: wrap; gap: .6rem; margin: 0 0 1.2rem; }
  dl div { background: var(--card); border: 1px solid var(--line); border-radius: 8px;
           padding: .5rem .9rem; min-width: 6.5rem; }
  dt { color: var(--quiet); font-size: 13px; }
  dd { margin: 0; font-size: 1.25rem; font-variant-numeric: tabular-nums; }
  table { border-collapse: separate; border-spacing: 0; width: 100%; background: var(--card);
          border: 1px solid var(--line); border-radius: 8px; }
  th, td { padding: .45rem .6rem; text-align: left; vertical-align: middle;
           border-bottom: 1px solid var(--line); }
  tbody tr:last-child td { border-bottom: 0; }
  th { position: sticky; top: 0; background: var(--card); padding: .2rem; }
  th:first-child { border-top-left-radius: 8px; }
  th:last-child { border-top-right-radius: 8px; }
  th button { font: inherit; font-size: 13px; font-weight: 600; color: inherit; background: none;
              border: 0; border-radius: 6px; padding: .35rem .4rem; cursor: pointer;
              white-space: nowrap; }
  th button:hover { background: var(--page); }
  th[aria-sort=ascending] button::after { content: " \25B2"; }
  th[aria-sort=descending] button::after { content: " \25BC"; }
  .number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  .done { color: var(--good); }
  .failed { color: var(--bad); }
  .why { display: block; color: var(--quiet); font-size: 13px; max-width: 46ch;
         overflow-wrap: anywhere; }
  .from { display: block; font-size: 13px; }
  img { display: block; width: 72px; height: 72px; object-fit: contain; background: var(--picture);
        border: 1px solid var(--line); border-radius: 4px; }
  td.picture { width: 90px; }
  .bare .picture { display: none; }
  @media (max-width: 760px) {
    table, thead, tbody { display: block; border: 0; background: none; }
    thead tr { display: flex; flex-wrap: wrap; gap: .3rem; margin-bottom: .8rem; }
    th { position: static; background: none; border: 0; padding: 0; }
    th button { background: var(--card); border: 1px solid var(--line); padding: .45rem .6rem; }
    th.picture { display: none; }
    tbody tr { display: grid; grid-template-columns: 84px repeat(3, 1fr); gap: .1rem .5rem;
               background: var(--card); border: 1px solid var(--line); border-radius: 8px;
               padding: .6rem; margin-bottom: .6rem; }
    td { border: 0; padding: .1rem 0; }
    td.picture { grid-row: 1 / span 4; width: auto; }
    td.wide { grid-column: 2 / -1; }
    .bare tbody tr { grid-template-columns: repeat(3, 1fr); }
    .bare td.wide { grid-column: 1 / -1; }
    td.number { text-align: left; }
    td.number::before { content: attr(data-label); display: block; color: var(--quiet);
                        font-size: 12px; }
  }
  @media print { th { position: static; } }
</style>
</head>
<body>
)";

/// Sorts rows when a heading is pressed: by numbers where cells have them, and back again.
constexpr const char* kBatchPageScript = R"(<script>
  const body = document.querySelector('tbody');
  const key = (row, column) => {
    const { value } = row.cells[column].dataset;
    return value === undefined ? row.cells[column].textContent : value === '' ? NaN : Number(value);
  };
  const order = (a, b, sign) => {
    if (typeof a === 'string') return sign * a.localeCompare(b, 'en', { numeric: true });
    return Number.isNaN(a) - Number.isNaN(b) || sign * (a - b) || 0;
  };
  document.querySelectorAll('th button').forEach((button) => {
    const heading = button.parentElement;
    button.addEventListener('click', () => {
      const isUp = heading.ariaSort !== 'ascending';
      document.querySelectorAll('th').forEach((each) => each.removeAttribute('aria-sort'));
      heading.setAttribute('aria-sort', isUp ? 'ascending' : 'descending');
      const rows = [...body.rows].map((row) => [key(row, heading.cellIndex), row]);
      rows.sort(([a], [b]) => order(a, b, isUp ? 1 : -1));
      body.append(...rows.map(([, row]) => row));
    });
  });
</script>
)";

}  // namespace abflat::cli

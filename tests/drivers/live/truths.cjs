// The page's truths.js, which has no page in it: prints what estimates are shown with.
const { readFileSync } = require('fs');
const source = readFileSync(`${__dirname}/../../../drivers/live/page/truths.js`, 'utf8');

(async () => {
  const { Truths } = await import(`data:text/javascript,${encodeURIComponent(source)}`);
  const between = (a, b, share) => a + (b - a) * share;
  const fresh = () => new Truths(between);
  const told = (truths, times) => { const shown = []; for (const t of times) truths.takeEstimate(t, (...what) => shown.push([what[0] ?? null, what[1]])); return shown; };

  const moving = fresh(), off = [];
  for (let i = 0; i <= 100; ++i) {
    const t = 100 + 0.1 * i;
    if (i % 2 === 0) moving.takeTruth(t, 3 * t);
    if (i % 2 === 0 && i < 100) moving.takeEstimate(t + 0.07, (truth) => off.push(truth - 3 * (t + 0.07)));
  }

  const hole = fresh();
  [1, 3].forEach((t) => hole.takeTruth(t, t));
  const in_a_hole = told(hole, [2]);

  const without = told(fresh(), [1, 2, 3.5]);

  const again = fresh();
  again.takeTruth(100, 1);
  again.takeTruth(9, 9);
  const another_run = told(again, [9]);
  console.log(JSON.stringify({ off, in_a_hole, without, another_run }));
})();

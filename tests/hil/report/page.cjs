// Opens a report in a real browser: node page.cjs BROWSER FILE PICTURE WIDTH light|dark. Saves a picture, then zooms. Prints what the
// page says and how its charts stand: their scales, and what a metre and a second are in pixels.
const openBrowser = require('../../npm/browser.cjs');
const [browserPath, file, picture, width, theme] = process.argv.slice(2);

// Runs in the page.
function read() {
  const text = (element) => element.innerText.replace(/\s+/g, ' ').trim();
  return [...document.querySelectorAll('figure.plot')].map((box) => {
    const { scales, over, axes } = box.chart.plot;
    return {
      title: box.ariaLabel, legend: text(box.querySelector('.legend')), x: [scales.x.min, scales.x.max], y: [scales.y.min, scales.y.max],
      marks: axes.map((axis) => axis._values.filter((mark) => mark !== '')),
      metre: [over.clientWidth / (scales.x.max - scales.x.min), over.clientHeight / (scales.y.max - scales.y.min)],
      rising: box.chart.plot.valToPos(scales.y.max, 'y') < box.chart.plot.valToPos(scales.y.min, 'y'),
    };
  });
}

(async () => {
  const browser = await openBrowser(browserPath);
  const page = await browser.newPage(), errors = [], loaded = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  page.on('request', (request) => loaded.push(request.url().slice(0, 60)));
  await page.setViewport({ width: Number(width), height: 900 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
  await page.goto(`file://${file}`, { waitUntil: 'load' });
  await page.screenshot({ path: picture, fullPage: true });
  const whole = await page.evaluate(read);
  const seen = {
    overflow: await page.evaluate(() => document.documentElement.scrollWidth - innerWidth),
    cut: await page.evaluate(() => [...document.querySelectorAll('.scroll')].filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.innerText.slice(0, 40))),
    cells: await page.evaluate(() => document.querySelector('.cards').innerText),
    labels: await page.evaluate(() => { const { content } = getComputedStyle(document.querySelectorAll('.cards td')[5], '::before'); return content === 'none' ? '' : content.replaceAll('"', ''); }),
    background: await page.evaluate(() => getComputedStyle(document.body).backgroundColor),
  };
  // The middle half of the first chart, dragged along its x axis; then the pointer in its middle.
  await page.evaluate(() => document.querySelector('.u-over').scrollIntoView());
  const at = await page.evaluate(() => { const { x, y, width: w, height: h } = document.querySelector('.u-over').getBoundingClientRect(); return { x, y, w, h }; });
  await page.mouse.move(at.x + at.w / 4, at.y + at.h / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + (3 * at.w) / 4, at.y + at.h / 2, { steps: 4 });
  await page.mouse.up();
  const zoomed = await page.evaluate(read);
  await page.mouse.move(at.x + at.w / 2, at.y + at.h / 2);
  const pointed = await page.evaluate(read);
  await page.mouse.click(at.x + at.w / 2, at.y + at.h / 2, { clickCount: 2 });
  await page.mouse.move(0, 0);
  const again = await page.evaluate(read);
  await page.evaluate(() => [...document.querySelectorAll('figure.plot')].at(-1).querySelector('[title="zoom in"]').click());
  const closer = await page.evaluate(read);
  await browser.close();
  console.log(JSON.stringify({ ...seen, whole, zoomed, pointed, again, closer, errors, loaded }));
})().catch((error) => { console.log(JSON.stringify({ failed: String(error) })); process.exit(1); });

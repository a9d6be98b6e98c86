// The page in a real browser: node page.cjs BROWSER URL FOLDER WIDTH light|dark. Waits until it has drawn, keeps a
// screenshot, prints what can be seen on it.
const puppeteer = require('puppeteer-core');
const path = require('path');
const [browserPath, url, folder, width, theme] = process.argv.slice(2);

// In the page: what stands in the table, and how much of each canvas is drawn in which colour.
function look() {
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const rgb = (hex) => { const full = hex.length === 4 ? hex.replace(/[^#]/g, '$&$&') : hex; return [1, 3, 5].map((i) => parseInt(full.slice(i, i + 2), 16)); };
  const pixels = (canvas, colour) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const [r, g, b] = rgb(css(colour));
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 128 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 24) ++count;
    return count;
  };
  return {
    rig: document.getElementById('rig').textContent,
    link: document.getElementById('link').textContent,
    background: getComputedStyle(document.body).backgroundColor,
    overflow: document.documentElement.scrollWidth - innerWidth,
    devices: [...document.querySelectorAll('#devices tbody tr')].map((row) => [...row.cells].slice(0, 3).map((cell) => cell.textContent)),
    figures: Object.fromEntries([...document.querySelectorAll('figure')].map((figure) => [
      figure.querySelector('figcaption').textContent,
      Object.fromEntries(['--c1', '--c2', '--c3', '--ok'].map((c) => [c, pixels(figure.querySelector('canvas'), c)]))])),
  };
}

(async () => {
  const browser = await puppeteer.launch({ executablePath: browserPath, headless: true, args: ['--no-sandbox', '--disable-gpu'] });
  const page = await browser.newPage();
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  await page.setViewport({ width: Number(width), height: 900 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
  await page.goto(url, { waitUntil: 'load' });
  await page.waitForFunction(() => document.querySelectorAll('#devices tbody tr').length > 0 && document.querySelectorAll('figure canvas').length > 3, { timeout: 20000 });
  await new Promise((resolve) => setTimeout(resolve, 2500)); // a few redraws, so that there are curves to see
  const seen = await page.evaluate(look);
  await page.screenshot({ path: path.join(folder, `page-${width}-${theme}.png`), fullPage: true });
  await browser.close();
  console.log(JSON.stringify({ ...seen, errors }));
})().catch((error) => { console.log(JSON.stringify({ failed: String(error) })); process.exit(1); });

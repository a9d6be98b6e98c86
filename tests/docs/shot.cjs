// Takes a picture of a page that is drawn: node shot.cjs BROWSER URL FILE WIDTH HEIGHT TEXT. Waits until the page has figures and says
// TEXT. If a heading says it, the picture begins there.
const openBrowser = require('../npm/browser.cjs');
const [browserPath, url, file, width, height, text] = process.argv.slice(2);

(async () => {
  const browser = await openBrowser(browserPath);
  const page = await browser.newPage();
  await page.setViewport({ width: Number(width), height: Number(height) });
  await page.goto(url, { waitUntil: 'load' });
  await page.waitForFunction((wanted) => document.querySelectorAll('figure canvas').length > 3 && document.body.innerText.includes(wanted), {}, text);
  await page.evaluate((wanted) => [...document.querySelectorAll('h2')].find((head) => head.innerText.includes(wanted))?.scrollIntoView(), text);
  await new Promise((resolve) => setTimeout(resolve, 1000)); // redraws
  await page.screenshot({ path: file });
  await browser.close();
})().catch((error) => { console.error(String(error)); process.exit(1); });

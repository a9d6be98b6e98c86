// Starts and stops a recording on the page of a run: node recording_page.cjs BROWSER URL PICTURE. Prints what the page says.
const openBrowser = require('../../npm/browser.cjs');
const [browserPath, url, picture] = process.argv.slice(2);

(async () => {
  const browser = await openBrowser(browserPath);
  const page = await browser.newPage(), errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  const button = '#recording button';
  const shows = (text) => page.waitForFunction((wanted) => document.querySelector('#recording button').textContent === wanted, {}, text);
  const says = () => page.$eval('#recording [role=status]', (element) => element.innerText.trim());
  await page.setViewport({ width: 390, height: 900 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }]);
  await page.goto(url, { waitUntil: 'load' });
  await page.waitForSelector('#recording:not([hidden])');
  await shows('Start');
  await page.click(button);
  await shows('Stop');
  await page.waitForFunction(() => Number(document.querySelector('#recording [role=status]').innerText.match(/([0-9.]+) MB/)?.[1]) > 0);
  const during = await says();
  await page.screenshot({ path: picture });
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  await page.click(button);
  await shows('Start');
  const after = await says();
  await browser.close();
  console.log(JSON.stringify({ during, after, overflow, errors }));
})().catch((error) => { console.log(JSON.stringify({ failed: String(error) })); process.exit(0); });

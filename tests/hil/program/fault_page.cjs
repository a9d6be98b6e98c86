// Drives the page of a run in a real browser: node fault_page.cjs BROWSER URL FOLDER. It tries a fault that is refused, sets
// one and clears it. It prints the answers of the page and measures screenshots at two widths, light and dark.
const openBrowser = require('../../npm/browser.cjs');
const path = require('path');
const [browserPath, url, folder] = process.argv.slice(2);
const looks = [[1280, 'light'], [1280, 'dark'], [400, 'light'], [400, 'dark']];

// Runs in the page: returns the positions of the controls.
function layout() {
  const rectOf = (element) => { const { x, y, width, height } = element.getBoundingClientRect(); return { x: x + scrollX, y: y + scrollY, width, height }; };
  const meet = (a, b) => a.x < b.x + b.width - 1 && b.x < a.x + a.width - 1 && a.y < b.y + b.height - 1 && b.y < a.y + a.height - 1;
  const section = rectOf(document.getElementById('orders'));
  const controls = [...document.querySelectorAll('#orders :is(select, input, button), #meaning, #answer, #in-force span')].map((element) => ({ name: element.name || element.id || element.textContent, rect: rectOf(element), is: element.matches('select, input, button') }));
  const outside = controls.filter(({ rect }) => rect.x < section.x || rect.x + rect.width > section.x + section.width).map(({ name }) => name);
  const overlaps = controls.flatMap((a, i) => controls.slice(i + 1).filter((b) => meet(a.rect, b.rect)).map((b) => `${a.name} | ${b.name}`));
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return {
    overflow: document.documentElement.scrollWidth - innerWidth, outside, overlaps,
    lowest: Math.min(...controls.filter(({ is }) => is).map(({ rect }) => rect.height)),
    rects: { button: rectOf(document.querySelector('#orders form button')), banner: rectOf(document.getElementById('faults')) },
    colours: { button: css('--c1'), text: css('--panel'), banner: css('--error') },
  };
}

// Runs in another page, on the screenshot: counts pixels of the button's colour, of its text and of the banner.
async function measure({ image, rects, colours }) {
  const picture = new Image();
  picture.src = `data:image/png;base64,${image}`;
  await picture.decode();
  const pen = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height }).getContext('2d');
  pen.drawImage(picture, 0, 0);
  const rgb = (hex) => { const full = hex.length === 4 ? hex.replace(/[^#]/g, '$&$&') : hex; return [1, 3, 5].map((i) => parseInt(full.slice(i, i + 2), 16)); };
  const count = ({ x, y, width, height }, colour) => {
    const { data } = pen.getImageData(Math.round(x), Math.round(y), Math.round(width), Math.round(height));
    let found = 0;
    for (let i = 0; i < data.length; i += 4) if (rgb(colour).reduce((off, part, k) => off + Math.abs(data[i + k] - part), 0) < 60) ++found;
    return found;
  };
  return { button: count(rects.button, colours.button), written: count(rects.button, colours.text), banner: count(rects.banner, colours.banner) };
}

(async () => {
  const browser = await openBrowser(browserPath);
  const page = await browser.newPage(), bench = await browser.newPage();
  await page.bringToFront();
  const errors = [], seen = { errors, looks: [] };
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  const until = (what, ...rest) => page.waitForFunction(what, {}, ...rest);
  const textOf = (selector) => page.$eval(selector, (element) => element.innerText.replace(/\s+/g, ' ').trim());
  const row = () => textOf('#devices tr[data-name="dvl"]');
  const stateIs = (state) => until((wanted) => document.querySelector('#devices tr[data-name="dvl"]')?.innerText.includes(wanted), state);
  const answers = async (start) => { await until((wanted) => document.getElementById('answer').innerText.startsWith(wanted), start); return textOf('#answer'); };
  const type = async (selector, text) => { await page.click(selector, { count: 3 }); await page.keyboard.press('Backspace'); await page.keyboard.type(text); };

  await page.setViewport({ width: 1280, height: 900 });
  await page.goto(url, { waitUntil: 'load' });
  await page.waitForSelector('#orders:not([hidden]) option[value="dvl"]');
  await stateIs('streaming');
  seen.before = await row();
  await page.select('#orders [name=device]', 'dvl');
  seen.words = await page.$$eval('#orders [name=fault] option', (all) => all.map(({ value }) => value));

  await page.select('#orders [name=fault]', 'drop');
  await type('#amounts input[data-key=probability]', '2');
  await page.click('#orders form button');
  seen.refused = await answers('refused');

  await page.select('#orders [name=fault]', 'hang');
  await type('#orders [name=for]', '');
  await page.keyboard.press('Enter'); // Enter has the same effect as the button
  seen.set = await answers('set');
  await stateIs('fault');
  await stateIs('stale');
  seen.during = await row();
  seen.banner = await textOf('#faults');
  const controls = (node) => [...(['combobox', 'textbox', 'button'].includes(node.role) ? [node] : []), ...(node.children ?? []).flatMap(controls)];
  seen.nameless = controls(await page.accessibility.snapshot()).filter(({ name }) => !name).map(({ role }) => role);

  for (const [width, theme] of looks) {
    await page.setViewport({ width, height: 900 });
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    // The lines of the devices change and wrap, so a picture counts only if nothing moved while it was taken.
    let place, image, moved = true;
    for (let tries = 0; moved && tries < 20; ++tries) {
      place = await page.evaluate(layout);
      image = Buffer.from(await page.screenshot({ path: path.join(folder, `faults-${width}-${theme}.png`), fullPage: true })).toString('base64');
      moved = JSON.stringify(place) !== JSON.stringify(await page.evaluate(layout));
    }
    seen.looks.push({ look: `${width} ${theme}`, ...place, ...await bench.evaluate(measure, { image, ...place }) });
  }

  await page.click('#in-force button');
  seen.cleared = await answers('cleared');
  await until(() => document.getElementById('faults').hidden);
  await stateIs('streaming');
  seen.after = await row();
  await browser.close();
  console.log(JSON.stringify(seen));
})().catch((error) => { console.log(JSON.stringify({ failed: String(error) })); process.exit(0); });

// Opens the page in a real browser: node page.cjs BROWSER URL FOLDER WIDTH light|dark. Waits until
// it is drawn and saves a screenshot. Prints the texts on the page and the measurements of the
// screenshot's pixels.
const openBrowser = require('../../npm/browser.cjs');
const path = require('path');
const [browserPath, url, folder, width, theme] = process.argv.slice(2);

// Runs in the page: reads texts and the positions of the figures.
function read() {
  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const rectOf = (element) => { const { x, y, width, height } = element.getBoundingClientRect(); return { x: x + scrollX, y: y + scrollY, width, height }; };
  const text = (element) => element?.innerText.replace(/\s+/g, ' ').trim() ?? '';
  const meet = (a, b) => a.x < b.x + b.width - 1 && b.x < a.x + a.width - 1 && a.y < b.y + b.height - 1 && b.y < a.y + a.height - 1;
  const figures = [...document.querySelectorAll('figure')];
  const apart = [...document.querySelectorAll('header > *, section, #faults')].concat(figures).map((element) => ({ element, rect: rectOf(element) }));
  const overlaps = apart.flatMap((a, i) => apart.slice(i + 1).filter((b) => !a.element.contains(b.element) && a.rect.width && b.rect.width && meet(a.rect, b.rect))
    .map((b) => `${text(a.element).slice(0, 30)} | ${text(b.element).slice(0, 30)}`));
  const cut = [...document.querySelectorAll('td, th, figcaption, .legend, header > *, #faults p')].filter((e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== 'inline').map(text);
  return {
    rig: text(document.getElementById('rig')), link: text(document.getElementById('link')), findings: text(document.getElementById('findings')), faults: text(document.getElementById('faults')),
    orders: !document.getElementById('orders').hidden, recording: !document.getElementById('recording').hidden,
    background: getComputedStyle(document.body).backgroundColor,
    overflow: document.documentElement.scrollWidth - innerWidth,
    overlaps, cut,
    estimators: [...document.querySelectorAll('#integrity tbody tr')].map((row) => [...row.cells].map(text)),
    devices: [...document.querySelectorAll('#devices tbody tr')].map((row) => [...row.cells].filter((cell) => cell.offsetWidth).map(text)),
    colours: Object.fromEntries(['--c1', '--c2', '--c3', '--c6', '--ok', '--error', '--panel'].map((name) => [name, css(name)])),
    figures: figures.map((figure) => ({
      title: figure.ariaLabel, caption: text(figure.querySelector('figcaption')), legend: text(figure.querySelector('.legend')),
      rect: rectOf(figure), canvas: rectOf(figure.querySelector('canvas')), section: text(figure.closest('section').querySelector('h2')),
    })),
  };
}

// Runs in another page and measures the screenshot. For each figure it counts the pixels of each
// colour, of a line's band and of a fault's shade, and the text pixels beside and below the plot.
async function measure({ image, colours, figures }) {
  const picture = new Image();
  picture.src = `data:image/png;base64,${image}`;
  await picture.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
  const pen = canvas.getContext('2d');
  pen.drawImage(picture, 0, 0);
  const rgb = (hex) => { const full = hex.length === 4 ? hex.replace(/[^#]/g, '$&$&') : hex; return [1, 3, 5].map((i) => parseInt(full.slice(i, i + 2), 16)); };
  const count = ({ x, y, width, height }, wanted, tolerance) => {
    const { data } = pen.getImageData(Math.round(x), Math.round(y), Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
    let found = 0;
    for (let i = 0; i < data.length; i += 4)
      if (wanted.reduce((off, part, k) => off + Math.abs(data[i + k] - part), 0) < tolerance) ++found;
    return found;
  };
  const panel = rgb(colours['--panel']), over = (under, name) => rgb(colours[name]).map((part, i) => under[i] + (part - under[i]) * (0x26 / 255));
  const shade = over(panel, '--error');
  const bands = [panel, shade].map((under) => over(under, '--c1')).flatMap((one) => [one, over(one, '--c2')]); // overlaps
  const ink = (rect) => Math.round(rect.width) * Math.round(rect.height) - count(rect, panel, 120);
  return Object.fromEntries(figures.map(({ title, rect, canvas: { x, y, width, height } }) => [title, {
    ...Object.fromEntries(['--c1', '--c2', '--c3', '--c6', '--ok'].map((name) => [name, count(rect, rgb(colours[name]), 24)])),
    band: bands.reduce((sum, colour) => sum + count(rect, colour, 8), 0), fault: count(rect, shade, 8),
    left: ink({ x, y, width: 16, height }), under: ink({ x, y: y + height - 20, width, height: 20 }),
  }]));
}

(async () => {
  const browser = await openBrowser(browserPath);
  const page = await browser.newPage();
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  await page.setViewport({ width: Number(width), height: 900 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: theme }]);
  await page.goto(url, { waitUntil: 'load' });
  await page.waitForFunction(() => document.querySelectorAll('#devices tbody tr').length > 0 && document.querySelectorAll('figure canvas').length > 3);
  await new Promise((resolve) => setTimeout(resolve, Number(process.argv[7] ?? 4000))); // redraws
  const bench = await browser.newPage();
  let seen, pixels;
  const look = async () => {
    await page.bringToFront();
    const places = ({ figures }) => JSON.stringify(figures.map(({ rect }) => rect));
    let image, before, tries = 0;
    do { // a line that breaks meanwhile moves the figures below it; the bench stands still at its end
      if (++tries > 150) throw new Error('the figures never stood still');
      const height = await page.evaluate(() => document.documentElement.scrollHeight); // a screenshot of more than the window moves them too
      await page.setViewport({ width: Number(width), height: Math.max(900, height) });
      before = places(await page.evaluate(read));
      image = Buffer.from(await page.screenshot({ path: path.join(folder, `page-${width}-${theme}.png`) })).toString('base64');
      seen = await page.evaluate(read);
    } while (places(seen) !== before);
    pixels = await bench.evaluate(measure, { image, ...seen });
  };
  // A busy machine is late with its plots: the shade of the fault tells how far they are.
  const behind = () => seen.faults && seen.figures.some(({ title }) => title !== 'Map' && title !== 'Satellites' && !(pixels[title].fault > 400));
  await look();
  for (let more = 0; more < 5 && behind(); ++more) {
    await new Promise((resolve) => setTimeout(resolve, 3000));
    await look();
  }
  await browser.close();
  for (const figure of seen.figures) Object.assign(figure, pixels[figure.title]);
  seen.figures = Object.fromEntries(seen.figures.map((figure) => [figure.title, figure]));
  console.log(JSON.stringify({ ...seen, errors }));
})().catch((error) => { console.log(JSON.stringify({ failed: String(error) })); process.exit(1); });

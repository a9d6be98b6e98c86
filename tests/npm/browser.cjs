// Chromium without a window: the browser of all tests that look at a page. On a busy machine it needs a minute to start.
const puppeteer = require('puppeteer-core');

module.exports = (path) =>
  puppeteer.launch({ executablePath: path, headless: true, timeout: 120000, args: ['--no-sandbox', '--disable-gpu'] });

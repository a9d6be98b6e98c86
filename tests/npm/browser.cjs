// Chromium without a window: the browser of all tests that look at a page. A busy machine needs
// minutes for what takes a second elsewhere. A wait ends just before ctest ends the test, so that
// the test can say what it waited for.
const puppeteer = require('puppeteer-core');
const patience = 240000; // ms

module.exports = async (path) => {
  const browser = await puppeteer.launch({ executablePath: path, headless: true, timeout: patience, protocolTimeout: patience, args: ['--no-sandbox', '--disable-gpu'] });
  const newPage = browser.newPage.bind(browser);
  browser.newPage = async () => {
    const page = await newPage();
    page.setDefaultTimeout(patience);
    page.setDefaultNavigationTimeout(patience);
    return page;
  };
  return browser;
};

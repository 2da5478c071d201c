"""Opens the page in an offline tab of Chromium, and has the functions that all checks share."""

import pathlib
import subprocess
import time
import urllib.parse

import axe_playwright_python

WEB = pathlib.Path(__file__).resolve().parent.parent
PAGE = (WEB / "dist" / "index.html").as_uri()
AXE = (pathlib.Path(axe_playwright_python.__file__).parent / "axe.min.js").read_text()
E6 = "xdot = y*(2*z - x);\nydot = x^2 - z^2;\nzdot = y*(z - 2*x);"
TOP = "xdot = a1*y*z;\nydot = a2*z*x;\nzdot = a3*x*y;"


def address(**given):
    return f"{PAGE}#{urllib.parse.urlencode(given)}"


def command(kahan, *arguments):
    return subprocess.run([kahan, *arguments], check=True, capture_output=True, text=True).stdout


class Tab:
    """A new tab of Chromium; an error in the tab's console fails the check."""

    def __init__(self, browser, url, **look):
        self.context = browser.new_context(offline=True, **look)
        self.page = self.context.new_page()
        self.complaints = []
        self.page.on("console", lambda said: self.complaints.append(said.text) if said.type == "error" else None)
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.begun = time.perf_counter()
        self.page.goto(url)

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        self.context.close()
        if kind is None:
            assert not self.complaints, self.complaints

    def seconds(self):
        return time.perf_counter() - self.begun

    def waits(self, what, timeout=60):
        self.page.wait_for_function(what, timeout=1000 * timeout)
        return self.seconds()

    def opened(self):
        return self.waits("document.querySelector('#formulas math') !== null")

    def text(self, selector):
        return self.page.inner_text(selector)


DRAWN = "document.querySelector('#ended').textContent.includes(' points ')"
FOUND = "document.querySelector('#search-stage').textContent.includes('Found in')"


def found(tab):
    """Runs a search; returns the lines found, and the seconds since the page began to load."""
    tab.opened()
    tab.page.click("#search")
    seconds = tab.waits(FOUND)
    return tab.text("#arrived").strip().splitlines(), seconds

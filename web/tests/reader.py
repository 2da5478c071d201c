"""What a reader does beside typing: keys, fingers, the history, wrong entries, print."""

from tab import AXE, DRAWN, E6, PAGE, Tab, address

SWING = {"field": "xdot = v;\nvdot = -x - x^2;", "eps": "0.1", "at": "1/5,0;3/10,0"}


def keys_alone_are_enough(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        keyboard = tab.page.keyboard
        for _ in range(60):
            if tab.page.evaluate("document.activeElement.id") == "portrait":
                break
            keyboard.press("Tab")
        assert tab.page.evaluate("document.activeElement.id") == "portrait"
        keyboard.press("Enter")
        tab.waits("document.querySelector('#ended').textContent.includes('3 orbits')")
        before = tab.page.evaluate("state.at[2]")
        keyboard.press("ArrowRight")
        tab.waits("document.querySelector('#ended').textContent.includes('3 orbits')")
        assert tab.page.evaluate("state.at[2]") != before
        keyboard.press("Delete")
        tab.waits("document.querySelector('#ended').textContent.includes('2 orbits')")
        width = "(([low, high]) => high - low)(frame.window[0])"
        whole = tab.page.evaluate(width)
        keyboard.press("+")
        tab.waits(f"{width} < {0.9 * whole}")
        keyboard.press("Shift+ArrowLeft")
        tab.waits(f"Math.abs({width} - {0.8 * whole}) < {1e-3 * whole}")
        keyboard.press("0")
        tab.waits(f"Math.abs({width} - {whole}) < {1e-9 * whole} && state.view === null")
        keyboard.press("Control+z")
        tab.waits("state.view !== null")
    print("keys alone begin, move and delete orbits, zoom, pan, fit and undo")


def fingers_scroll_zoom_and_tap(browser, _):
    look = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
    with Tab(browser, address(**SWING), **look) as tab:
        tab.waits(DRAWN)
        tab.page.locator("#portrait").scroll_into_view_if_needed()
        box = tab.page.locator("#portrait").bounding_box()
        middle = [box["x"] + box["width"] / 2, box["y"] + 0.85 * box["height"]]
        session = tab.context.new_cdp_session(tab.page)
        before = tab.page.evaluate("[state.at.join(';'), scrollY]")
        finger = lambda up: [{"x": middle[0], "y": middle[1] - up, "id": 1}]
        session.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": finger(0)})
        for up in range(20, 221, 20):
            session.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": finger(up)})
        session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        tab.waits(f"scrollY > {before[1]} + 100")
        assert tab.page.evaluate("state.at.join(';')") == before[0], "a swipe begins no orbit"
        tab.page.locator("#portrait").scroll_into_view_if_needed()
        box = tab.page.locator("#portrait").bounding_box()
        middle = [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]
        fingers = lambda half: [{"x": middle[0] - half, "y": middle[1], "id": 1}, {"x": middle[0] + half, "y": middle[1], "id": 2}]
        wide = tab.page.evaluate("frame.window[0][1] - frame.window[0][0]")
        session.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": fingers(30)})
        for half in range(30, 91, 10):
            session.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": fingers(half)})
        session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        tab.waits(f"frame.window[0][1] - frame.window[0][0] < {0.6 * wide}")
        assert tab.page.evaluate("state.at.join(';')") == before[0], "a pinch begins no orbit"
        tab.page.touchscreen.tap(middle[0] + 40, middle[1] + 60)
        tab.waits("document.querySelector('#ended').textContent.includes('3 orbits')")
    print("a swipe scrolls, a pinch zooms, and a tap begins an orbit")


def the_mouse_pans_zooms_and_leaves_the_right_button_alone(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        tab.page.locator("#portrait").scroll_into_view_if_needed()
        box = tab.page.locator("#portrait").bounding_box()
        at = [box["x"] + 0.3 * box["width"], box["y"] + 0.2 * box["height"]]
        mouse = tab.page.mouse
        before = tab.page.evaluate("frame.window[0]")
        mouse.click(*at, button="right")
        mouse.move(*at)
        mouse.down()
        mouse.move(at[0] + 60, at[1], steps=3)
        mouse.up()
        tab.waits(f"frame.window[0][0] < {before[0]}")
        assert tab.page.evaluate("state.at.length") == 2, "neither the right button nor a drag begins an orbit"
        # A wheel over a picture without the focus scrolls the page.
        tab.page.locator("#field").focus()
        wide = "(frame.window[0][1] - frame.window[0][0])"
        now = tab.page.evaluate(wide)
        tab.page.locator("#portrait").focus()
        mouse.wheel(0, -400)
        tab.waits(f"{wide} < {0.7 * now}")
        tab.page.click("#fit")
        tab.waits("state.view === null")
    print("the mouse pans and zooms, and its right button does nothing")


def back_brings_back_what_was_typed(browser, _):
    with Tab(browser, PAGE) as tab:
        tab.opened()
        tab.waits(DRAWN)
        own = "xdot = x - x*y;\nydot = x*y - y;"
        tab.page.fill("#field", own)
        tab.waits(f"{DRAWN} && state.field === {own!r} && state.at.length > 2")
        tab.page.click("#classical li:nth-child(2) button")
        tab.waits("state.at[0].split(',').length === 5")
        tab.page.go_back()
        tab.waits(f"state.field === {own!r} && document.querySelector('#field').value === {own!r}")
        tab.page.click("#undo")
        tab.waits("state.field.startsWith('xdot = v')")
        tab.page.click("#redo")
        tab.waits(f"document.querySelector('#field').value === {own!r}")
    print("Back and Undo bring back what was typed")


def wrong_entries_are_answered(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        tab.page.click("#more summary")
        entries = [("#eps", "0,15", "0.15"), ("#at", "a,b", "a where a number"), ("#at", "1", "2 numbers"), ("#steps", "10000000", "1000000 steps"), ("#ranges input", "x", "range across")]
        for box, text, said in entries:
            tab.page.fill(box, text)
            tab.page.press(box, "Tab")
            tab.waits(f"document.querySelector('#refused').textContent.includes({said!r})")
        tab.page.evaluate("(async () => { state.at = Array(12).fill('1/5,0'); state.picked = 0; await move(); add([0.1, 0.1]) })()")
        tab.waits("document.querySelector('#refused').textContent.includes('12 orbits')")
    with Tab(browser, address(field="xdot = y; ydot = -x*z; zdot = a*xy - z;")) as tab:
        tab.opened()
        tab.waits("document.querySelector('#read').textContent.includes('is x*y meant?')")
        tab.waits(DRAWN)
    print("what cannot be read or done is answered in words")


def mistakes_wait_and_move_nothing(browser, _):
    with Tab(browser, address(field=E6)) as tab:
        tab.waits(DRAWN)
        place = tab.page.locator("#portrait").bounding_box()
        tab.page.locator("#field").press("End")
        tab.page.keyboard.type(" + x*y*z*u", delay=60)
        assert tab.page.is_hidden("#mistake"), "no mistake is shown between keys"
        tab.waits("!document.querySelector('#mistake').hidden")
        assert tab.page.locator("#portrait").bounding_box() == place
    print("mistakes wait for a pause, and move nothing")


def one_escaping_orbit_leaves_the_view(browser, _):
    with Tab(browser, address(field="xdot = x;\nydot = -y;", eps="0.05", at="1,1;2,1", beside="euler")) as tab:
        tab.waits(DRAWN)
        assert "Orbit 1 escapes after" in tab.text("#ended") and "Orbit 2 escapes after" in tab.text("#ended")
        wide = tab.page.evaluate("frame.window[0][1] - frame.window[0][0]")
        assert wide < 100, wide
    print("orbits that escape say so, and leave the view as it is")


def print_shows_pictures_and_no_buttons(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        tab.page.emulate_media(media="print")
        assert not [made for made in tab.page.query_selector_all("button") if made.is_visible()]
        for canvas in ["#portrait", "#drift"]:
            drawn, printed = tab.page.eval_on_selector(canvas, "it => [it.width / it.height, it.getBoundingClientRect().width / it.getBoundingClientRect().height]")
            assert abs(drawn / printed - 1) < 0.02, (canvas, drawn, printed)
        assert tab.page.pdf()[:4] == b"%PDF"
    print("in print there are pictures, and no buttons")


def a_reload_keeps_what_was_found(browser, _):
    with Tab(browser, address(field=E6, eps="0.05", at="1,1/2,1/3")) as tab:
        tab.waits("document.querySelector('#arrived').textContent.includes('H1')")
        found = tab.text("#arrived")
        tab.page.reload()
        tab.waits("document.querySelector('#arrived').textContent.includes('H1')")
        assert tab.text("#arrived") == found
    print("a reload keeps what was found")


def pictures_play(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        tab.page.click("#play")
        tab.waits("played > 0 && played < 1 && playing !== 0")
        tab.page.click("#play")
        assert tab.page.evaluate("playing === 0 && shownRows(4001) < 4001")
        tab.page.fill("#time", "1000")
        assert tab.page.evaluate("shownRows(4001)") == 4001
    print("the picture plays, pauses, and goes to a time")


def headings_are_in_order(browser, _):
    with Tab(browser, address(system="e6")) as tab:
        tab.opened()
        tab.waits(DRAWN)
        levels = tab.page.eval_on_selector_all("h1,h2,h3,h4,h5", "all => all.map(one => Number(one.tagName[1]))")
        assert levels[0] == 1 and all(after <= before + 1 for before, after in zip(levels, levels[1:])), levels


CHECKS = [
    keys_alone_are_enough,
    fingers_scroll_zoom_and_tap,
    the_mouse_pans_zooms_and_leaves_the_right_button_alone,
    back_brings_back_what_was_typed,
    wrong_entries_are_answered,
    mistakes_wait_and_move_nothing,
    one_escaping_orbit_leaves_the_view,
    print_shows_pictures_and_no_buttons,
    a_reload_keeps_what_was_found,
    pictures_play,
    headings_are_in_order,
]

"""Tests what a user does besides typing a field: keys, touch, the history, wrong entries, print,
overlays, downloads and links."""

import pathlib
import xml.etree.ElementTree

from tab import DRAWN, E6, PAGE, Tab, address

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


# JavaScript that returns the picture as SVG.
VECTOR = "(() => { const paper = new VectorCanvas($('portrait')); drawPortrait(paper); return paper.text() })()"


def level_curves_go_through_first_points(browser, _):
    with Tab(browser, address(**SWING, over="levels")) as tab:
        tab.waits("document.querySelector('#levelled').textContent.includes('Curves on which H')")
        tab.waits("inPlane.answer?.columns.length === 3 * GRID[0] * GRID[1]")
        # The integral at the grid points next to the orbit is close to its value on the orbit.
        far = tab.page.evaluate(
            """(() => {
                const [{columns, integrals}] = lastDrawn, {answer: {columns: grid, window}} = inPlane
                const values = grid.subarray(2 * GRID[0] * GRID[1]), goal = columns[integrals[0]]
                const nearest = [2, 3].map((k, axis) => columns[k].map(value => Math.round((value - window[axis][0]) / (window[axis][1] - window[axis][0]) * GRID[axis] - 0.5)))
                const seen = Array.from(goal, (value, row) => Math.abs(values[nearest[1][row] * GRID[0] + nearest[0][row]] - value))
                return Math.max(...seen) / (values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b)))
            })()"""
        )
        assert far < 0.1, far
        with_curves = tab.page.evaluate(VECTOR).count("<path")
        tab.page.click("#more summary")
        tab.page.uncheck("#overlays input[value=levels]")
        tab.waits("document.querySelector('#levelled').textContent === ''")
        assert with_curves == tab.page.evaluate(VECTOR).count("<path") + 2
    with Tab(browser, address(field=E6, eps="0.05", at="1,1/2,1/3", over="levels")) as tab:
        tab.waits("document.querySelector('#levelled').textContent.includes('two variables')")
    print("level curves of an integral go through the first points")


def orbits_have_colours_of_their_own(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        second = tab.page.evaluate("PAINTS[1]")
        assert second not in tab.page.evaluate(VECTOR)
        tab.page.click("#more summary")
        tab.page.check("#overlays input[value=colours]")
        tab.waits("location.hash.includes('over=colours')")
        # The ring and the points of the second orbit have this colour.
        assert tab.page.evaluate(VECTOR).count(second) == 2
        # Draws the picture after a change of first points, before their orbits are computed.
        tab.page.evaluate("state.at = [...state.at, ...state.at, '1/2,1/3']; drawPortrait(); state.at = state.at.slice(0, 1); state.picked = 0; drawPortrait()")
    print("each orbit has a colour, where that is wished")


def what_is_shown_is_taken_away(browser, _):
    with Tab(browser, address(**SWING, over="directions,nullclines")) as tab:
        tab.waits(DRAWN)
        tab.waits("inPlane.answer !== null")
        files = {}
        for button in ["svg", "png", "csv"]:
            with tab.page.expect_download() as down:
                tab.page.click(f"#{button}")
            files[button] = pathlib.Path(down.value.path()).read_bytes()
        drawing = xml.etree.ElementTree.fromstring(files["svg"])
        of = lambda tag: list(drawing.iter(f"{{http://www.w3.org/2000/svg}}{tag}"))
        assert {"x", "v"} <= {text.text for text in of("text")}
        # The drawing has the points of orbits, and in the frame arrows and two nullclines.
        paths = [path.get("d") for path in of("path")]
        assert sum(path.count("h0") > 1000 for path in paths) >= 2 and not any("NaN" in path for path in paths)
        assert sum(path.get("clip-path") is not None for path in of("path")) >= 3
        assert files["png"][:4] == b"\x89PNG"
        lines = files["csv"].decode().splitlines()
        assert lines[0] == "orbit,method,n,t,x,v" and sum(",kahan," in line for line in lines) == 2 * 4001
    print("the picture is taken away as SVG and PNG, the points as CSV")


def the_pointer_reads_coordinates(browser, _):
    with Tab(browser, address(**SWING)) as tab:
        tab.waits(DRAWN)
        tab.page.locator("#portrait").scroll_into_view_if_needed()
        box = tab.page.locator("#portrait").bounding_box()
        tab.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
        tab.waits("document.querySelector('#where').textContent !== ''")
        x, v = [float(part.split("=")[1].replace("−", "-").replace("·10⁻", "e-").translate(RAISED)) for part in tab.text("#where").split(",")]
        at = tab.page.evaluate("frame.point(frame.width / 2, frame.height / 2)")
        wide = tab.page.evaluate("frame.window.map(([low, high]) => high - low)")
        assert abs(x - at[0]) < 0.01 * wide[0] and abs(v - at[1]) < 0.01 * wide[1], (x, v, at)
        tab.page.mouse.move(box["x"] - 20, box["y"])
        tab.waits("document.querySelector('#where').textContent === ''")
    print("the pointer reads coordinates")


RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


def an_embedded_page_is_field_and_picture(browser, _):
    for url in [f"{PAGE}#embed", address(**SWING, embed="1")]:
        with Tab(browser, url) as tab:
            tab.waits(DRAWN)
            assert all(tab.page.is_visible(part) for part in ["#field", "#portrait", "#drift"])
            assert not any(tab.page.is_visible(part) for part in ["header", "footer", "#rest", "#exhibits"])
            assert "embed" in tab.page.evaluate("location.hash")
    print("an embedded page is field and picture alone")


def three_variables_turn_in_a_box(browser, _):
    with Tab(browser, address(field=E6, eps="0.05", at="1,1/2,1/3", axes="x,y")) as tab:
        tab.waits(DRAWN)
        tab.page.click("#more summary")
        tab.page.select_option("#inwards", "z")
        tab.waits("location.hash.includes('axes=x%2Cy%2Cz')")
        # The drawing has the names of the three axes, and the points of the orbit.
        drawing = tab.page.evaluate(VECTOR)
        assert all(f">{name}</text>" in drawing for name in "xyz") and drawing.count("h0") > 500
        # At the angles [0, 0], the picture shows y across and z upwards.
        assert tab.page.evaluate("seenFrom([0, 0], [[0, 2], [0, 2], [0, 4]])([1, 2, 2]).map(value => Math.round(1000 * value))") == [577, 0]
        tab.page.locator("#portrait").scroll_into_view_if_needed()
        box = tab.page.locator("#portrait").bounding_box()
        mouse, before = tab.page.mouse, tab.page.evaluate("[state.turn, state.at.join(';')]")
        mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
        mouse.down()
        mouse.move(box["x"] + 0.5 * box["width"] + 60, box["y"] + 0.5 * box["height"] + 12, steps=3)
        mouse.up()
        after = tab.page.evaluate("[state.turn, state.at.join(';')]")
        assert abs(before[0][0] - after[0][0] - 0.5) < 1e-9 and abs(after[0][1] - before[0][1] - 0.1) < 1e-9, (before, after)
        assert before[1] == after[1], "neither a drag nor a click begins an orbit"
        tab.waits(f"({VECTOR}) !== {drawing!r}")
        tab.page.press("#turn", "ArrowRight")
        tab.waits(f"state.turn[0] !== {after[0][0]}")
        shared = tab.page.url
    with Tab(browser, shared) as tab:
        tab.waits(DRAWN)
        assert tab.page.evaluate("isSpace() && state.turn[1].toFixed(2)") == f"{after[0][1]:.2f}"
        tab.page.click("#more summary")
        tab.page.select_option("#inwards", "")
        tab.waits("!isSpace() && frame.starts[0].length === 2")
    print("three variables are seen in a box that turns")


def a_link_holds_what_was_found(browser, _):
    start = {"field": E6, "eps": "0.05", "at": "1,1/2,1/3"}
    with Tab(browser, address(**start)) as tab:
        tab.waits("searched?.lines?.length > 0")
        lines, link = tab.text("#arrived"), tab.page.evaluate("linkWithFindings()")
    assert "H1" in lines and len(link) < 8192
    with Tab(browser, link) as tab:
        tab.waits("document.querySelector('#search-stage').textContent.includes('proved once more')")
        tab.waits("document.querySelector('#drifting').textContent.includes('H1')")
        assert tab.text("#arrived") == lines
        assert tab.page.eval_on_selector_all("#search-shown .preserved", "all => all.length") == len(lines.splitlines())
        assert "found=" not in tab.page.url
    # The page ignores a false claim in the link, and runs a search instead.
    with Tab(browser, address(**start, found="integral H1 = x;")) as tab:
        tab.waits("document.querySelector('#search-stage').textContent.includes('Found in')")
        assert tab.text("#arrived") == lines
    print("a link holds what was found, which is proved once more")


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
    level_curves_go_through_first_points,
    orbits_have_colours_of_their_own,
    what_is_shown_is_taken_away,
    the_pointer_reads_coordinates,
    an_embedded_page_is_field_and_picture,
    three_variables_turn_in_a_box,
    a_link_holds_what_was_found,
]

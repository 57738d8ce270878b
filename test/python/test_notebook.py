# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Pages in the cells of a notebook, which a browser opens.

import os
import pathlib
import shutil

import pytest

import intrinsic_triangulations as it

for package in ("nbformat", "nbclient", "ipykernel", "selenium"):
    pytest.importorskip(package, reason=f"skipped: there is no package {package} (on Debian: apt install python3-{package})")
if not (os.environ.get("IDT_COMMAND") or shutil.which("idt")):
    pytest.skip("skipped: there is no command idt", allow_module_level=True)
if not shutil.which("chromium") or not shutil.which("chromedriver"):
    pytest.skip("skipped: there is no chromium or no chromium-driver", allow_module_level=True)

import nbclient
import nbformat
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

CELLS = (
    """import intrinsic_triangulations as it
V, F = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, 0, 1]], [[0, 1, 2], [1, 0, 3]]
t = it.Triangulation(V, F)
t.flip_to_delaunay()
t.show()""",
    "it.view(V, F, values=[0, 1, 2, 3])",
)

# Calls back with the number of colours of a picture.
COUNT = """const [shot, done] = arguments, image = new Image();
image.onload = () => {
  const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
  context.drawImage(image, 0, 0);
  done(new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size);
};
image.src = "data:image/png;base64," + shot;"""


@pytest.fixture
def browser(tmp_path):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for word in ("headless=new", "no-sandbox", "disable-gpu", "use-gl=angle", "use-angle=swiftshader", "enable-unsafe-swiftshader",
                 "no-first-run", "disable-background-networking", "disable-component-update", "disable-sync", "window-size=1000,1400",
                 f"user-data-dir={tmp_path / 'profile'}"):
        options.add_argument("--" + word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    driver.set_script_timeout(120)
    yield driver
    driver.quit()


def test_cells_show_surfaces(tmp_path, monkeypatch, browser):
    # A kernel need not be of the Python that runs the tests.
    monkeypatch.setenv("PYTHONPATH", str(pathlib.Path(it.__file__).parents[1]))
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
    nbclient.NotebookClient(notebook, timeout=120, startup_timeout=120, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells for output in cell.outputs]
    assert [output.output_type for output in outputs] == ["execute_result"] * 2
    page = tmp_path / "notebook.html"
    page.write_text("<!DOCTYPE html>" + "".join(output.data["text/html"] for output in outputs), encoding="utf-8")
    browser.get(page.as_uri())
    frames = browser.find_elements(By.TAG_NAME, "iframe")
    assert len(frames) == 2
    for frame, has_values in zip(frames, (False, True)):
        browser.switch_to.frame(frame)
        browser.execute_async_script("""const done = arguments[0], wait = () =>
          picture.number_of_pictures && !picture.is_requested ? done() : setTimeout(wait, 50); wait();""")
        text = browser.find_element(By.ID, "panel").text
        assert "input alone: 1" in text and "both: 4" in text and ("values" in text) == has_values
        assert browser.execute_async_script(COUNT, browser.find_element(By.ID, "canvas").screenshot_as_base64) > 20
        browser.switch_to.default_content()
    assert [entry for entry in browser.get_log("browser") if "GPU stall" not in entry["message"]] == []

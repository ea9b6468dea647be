"""The Python examples of the README and of docs/ run as they stand there, and links lead somewhere."""

import contextlib
import io
import re
import subprocess
import unittest

from support import source_folder, temporary_folder

PAGES = ("README.md", "docs/filters.md", "docs/python.md")


def examples(page):
    text = (source_folder / page).read_text()
    return re.findall(r"^```python\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)


def commands(page):
    """The indented lines that call `vesicle`."""
    return re.findall(r"^    (vesicle .*)$", (source_folder / page).read_text(), flags=re.MULTILINE)


class Documentation(unittest.TestCase):
    def test_has_examples(self):
        self.assertGreaterEqual(len(examples("README.md")), 1)
        self.assertGreaterEqual(len(examples("docs/filters.md")), 1)
        self.assertGreaterEqual(len(examples("docs/python.md")), 4)

    def test_examples_run_and_leave_what_they_say(self):
        for page in PAGES:
            for code in examples(page):
                with self.subTest(page=page, code=code), temporary_folder() as folder:
                    exec(compile(code, page, "exec"), {"__name__": "__main__"})
                    for name in re.findall(r'"(\w+\.(?:vtu|png))"\)', code):
                        self.assertGreater((folder / name).stat().st_size, 1000, name)

    def test_the_tutorial_is_what_happens(self):
        page = "docs/tutorial.md"
        with temporary_folder() as folder:
            for command in commands(page):
                if " tradeoff " not in command:  # minutes
                    done = subprocess.run(command, shell=True, capture_output=True, text=True)
                    self.assertEqual(done.returncode, 0, f"{command}: {done.stderr}")
            self.assertGreater((folder / "shapes.png").stat().st_size, 1000)
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                for code in examples(page):
                    exec(compile(code, page, "exec"), {"__name__": "__main__"})
        for line in printed.getvalue().splitlines()[:3]:
            self.assertIn(f"    {line}\n", (source_folder / page).read_text())

    def test_links_lead_somewhere(self):
        for page in (*sorted(source_folder.glob("*.md")), *sorted(source_folder.glob("[de]*/*.md"))):
            for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text()):
                with self.subTest(page=page.name, link=link):
                    self.assertTrue((page.parent / link).exists())


if __name__ == "__main__":
    unittest.main()

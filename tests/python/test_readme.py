"""The Python examples of the README run as they stand there."""

import re
import unittest

from support import source_folder, temporary_folder


def examples():
    text = (source_folder / "README.md").read_text()
    return re.findall(r"^```python\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)


class Readme(unittest.TestCase):
    def test_has_examples(self):
        self.assertGreaterEqual(len(examples()), 2)

    def test_examples_run_and_leave_what_they_say(self):
        for code in examples():
            with self.subTest(code=code), temporary_folder() as folder:
                exec(compile(code, "README.md", "exec"), {"__name__": "__main__"})
                for name in re.findall(r'"(\w+\.(?:vtu|png))"\)', code):
                    self.assertGreater((folder / name).stat().st_size, 1000, name)


if __name__ == "__main__":
    unittest.main()

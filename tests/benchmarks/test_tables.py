#!/usr/bin/env python3
"""The tables of sample.json, whose numbers are such that the answers are plain."""

import pathlib
import sys
import tempfile
import unittest

folder = pathlib.Path(__file__).parent
sys.path.insert(0, str(folder))

import tables


class Tables(unittest.TestCase):
    def setUp(self):
        self.measured = tables.Measured([folder / "sample.json"])
        self.report = tables.report(self.measured)

    def row(self, table, start):
        """The cells of the row of a table that starts so."""
        below = self.report[self.report.index(f"### {table}\n"):]
        line = below[below.index(f"\n| {start} |") + 1:].splitlines()[0]
        return [cell.strip() for cell in line.strip("|").split("|")][1:]

    def test_names_are_without_what_the_library_adds(self):
        self.assertEqual(
            tables.plain_name("Step/pear/320/threads:2/iterations:1/process_time/real_time"),
            "Step/pear/320/threads:2")

    def test_three_digits(self):
        for x, text in [(0, "0"), (16, "16"), (12345, "12,345"), (1234.5, "1,230"), (0.0625, "0.0625"),
                        (2.999, "3.00"), (0.004, "4.0e-3"), (2.5e12, "2.5e12")]:
            self.assertEqual(tables.number(x), text)

    def test_the_fastest_repetition_of_a_kernel_counts(self):
        self.assertEqual(self.row("Kernels", "kernel, AVX-512, double"), ["80", "1", "0.800", "0.800"])
        self.assertEqual(self.row("Kernels", "direct sum, single"), ["160", "2", "1.80", "0.900"])

    def test_the_median_step_counts(self):
        self.assertEqual(self.row("Steps", "320"), ["20", "4", "", "16", "", "", ""])

    def test_growth_between_sizes(self):
        self.assertEqual(self.row("Steps", "1,280"), ["80", "25", "1", "16", "", "", ""])

    def test_the_lower_bound_and_the_least_memory(self):
        # 18 applies, half of them in double precision, of 1e6 pairs at 1 and 2 a nanosecond on two
        # cores: 6.75 ms of 20.
        self.assertEqual(self.row("What a pear's step takes", "320"),
                         ["30", "1.50", "1.50", "0.338", "50", "100"])

    def test_failed_runs_and_aggregates_are_left_out(self):
        self.assertFalse(self.measured.has("Step/pear/5120/threads:2"))
        self.assertNotIn("999", self.report)

    def test_paper_is_extrapolated_by_its_own_order(self):
        # Of second order: √10 as many triangles, ten times the time.
        self.assertEqual(
            self.row("The paper's scheme", "E, v = .8"),
            ["4.0e-3", "0.500", "1.0e-3", "2", "0.0100", "10", "2", "8,100", "100", "50"])

    def test_goals(self):
        goals = self.report[self.report.index("Goals met"):]
        self.assertIn("- step, 320 triangles: 20 ms, at most 4 ms", goals)
        self.assertIn("- paper's time at equal error, E, v = .8: 50, at least 100", goals)
        self.assertNotIn("processors", goals)
        self.assertNotIn("memory, 320", goals)


    def test_a_page_keeps_what_is_around_its_tables(self):
        with tempfile.TemporaryDirectory() as there:
            page = pathlib.Path(there) / "page.md"
            page.write_text("above\n" + "old\n".join(tables.MARKS) + "below\n", encoding="utf-8")
            tables.put_into(page, "new\n")
            self.assertEqual(page.read_text(encoding="utf-8"),
                             "above\n" + "\nnew\n\n".join(tables.MARKS) + "below\n")


if __name__ == "__main__":
    unittest.main()

"""The module for Python, against what follows from the profile and the force law."""
import sys

try:
    import numpy
except ImportError:
    print("skipped: python3 has no NumPy: apt install python3-numpy")
    sys.exit(77)

import os
import tempfile
import unittest

import moontrace


def page_of_an_i():
    text = moontrace.Text(moontrace.Script(), "i", sheet="60x50", letter_size=0.020)
    return text, moontrace.Page(text)


class Python(unittest.TestCase):
    def test_letters_stand_where_the_text_has_them(self):
        page = moontrace.page("moon", sheet="a5")
        self.assertEqual([letter.sign for letter in page.letters], ["m", "o", "o", "n"])
        self.assertEqual([letter.source_begin for letter in page.letters], [0, 1, 2, 3])
        self.assertAlmostEqual(page.letters[0].x, 0.015)  # the margin of A5
        self.assertAlmostEqual(page.letters[0].y, 0.210 - 0.015 - 0.012)  # an em below it
        self.assertAlmostEqual(page.width, 0.148)

    def test_a_height_map_holds_the_groove_to_its_depth(self):
        text, page = page_of_an_i()
        heights = page.height_map(0.0001)
        self.assertEqual(heights.shape, (500, 600))
        self.assertEqual(heights.max(), 0)  # engraved
        self.assertAlmostEqual(heights.min(), -text.depth, delta=0.00005)  # slope about 1, cells 0.1 mm
        self.assertAlmostEqual(text.depth, 0.5 * 0.1165 * 0.020)
        row, column = numpy.unravel_index(heights.argmin(), heights.shape)
        self.assertEqual(heights[row, column], page.sample(0.0001 * (column + 0.5), 0.0001 * (row + 0.5))[0])

    def test_arrays_agree_with_single_points_wherever_they_lie(self):
        _, page = page_of_an_i()
        points = numpy.random.default_rng(5).uniform((0, 0), (0.06, 0.05), (4000, 2))
        expected = numpy.array([page.sample(x, y) for x, y in points])
        self.assertGreater(numpy.count_nonzero(expected[:, 0]), 50)
        for same in (points, numpy.asfortranarray(points), points[::-1][::-1], points.tolist()):
            self.assertTrue(numpy.array_equal(page.samples(same), expected))
        self.assertTrue(numpy.array_equal(page.samples(points[::3]), expected[::3]))
        self.assertTrue(numpy.array_equal(page.samples(points[::-1]), expected[::-1]))
        out = numpy.zeros((4000, 4))
        self.assertIs(page.samples(points, out=out[:, 1:]).base, out)
        self.assertTrue(numpy.array_equal(out[:, 1:], expected))
        self.assertFalse(out[:, 0].any())

    def test_an_object_carries_the_page(self):
        text, page = page_of_an_i()
        mug = moontrace.Object(page, "cylinder", (0.04, 0.05, 0))
        self.assertEqual(mug.face, "round")
        self.assertAlmostEqual(mug.greatest_scale, 1)  # its side is true to scale
        letter = page.letters[0]
        # across the letter's middle; 0.1 mm deep in the wall the front pushes towards -y
        places = numpy.array([mug.place(letter.x + 0.0001 * i, letter.y + 0.01, -0.0001) for i in range(200)])
        samples = mug.samples(places)
        self.assertAlmostEqual(samples[:, 0].min(), -text.depth, delta=0.00005)
        self.assertTrue(numpy.allclose(samples[:, 4], -0.0001, atol=1e-12))
        self.assertEqual(tuple(samples[70]), mug.sample(*places[70]))
        forces = mug.forces(places)
        self.assertEqual(tuple(forces[70]), mug.force(*places[70]))
        self.assertLess(forces[:, 1].min(), -0.09)  # 1000 N/m times 0.1 mm
        with self.assertRaises(moontrace.Error):
            moontrace.Object(page, "cylinder", (0.001, 0.001, 0))

    def test_forces_along_a_path_have_an_energy(self):
        # Once round a closed path within the surface, the potential law does no work: the sum of the
        # middle forces times the steps is zero but for the steps' own error, which goes as their
        # square: with steps of 0.3 um and a curvature of force below 1e7 N/m2 far below 1 uJ.
        _, page = page_of_an_i()
        letter = page.letters[0]
        angle = numpy.linspace(0, 2 * numpy.pi, 200001)
        path = numpy.column_stack((letter.x + 0.002 + 0.004 * numpy.cos(angle),
                                   letter.y + 0.010 + 0.004 * numpy.sin(angle),
                                   -0.001 - 0.0002 * numpy.sin(3 * angle)))
        forces = page.forces(path)
        self.assertGreater(abs(forces[:, 0]).max(), 0.1)  # it meets the groove's flanks
        work = numpy.sum(0.5 * (forces[1:] + forces[:-1]) * numpy.diff(path, axis=0))
        self.assertLess(abs(work), 1e-7)
        for i in range(0, len(path), 20001):
            self.assertEqual(tuple(forces[i]), page.force(*path[i]))

    def test_flat_paper_is_a_spring(self):
        _, page = page_of_an_i()
        self.assertAlmostEqual(page.force(0.001, 0.001, -0.0005)[2], 0.5)
        self.assertAlmostEqual(page.force(0.001, 0.001, -0.0005, stiffness=300, law=1)[2], 0.15)

    def test_what_is_refused_is_raised_with_its_code(self):
        _, page = page_of_an_i()
        for call, code in ((lambda: page.sample(float("nan"), 0), moontrace.BAD_CALL),
                           (lambda: page.samples([[0.0, numpy.inf]]), moontrace.BAD_CALL),
                           (lambda: page.samples([[0.0, 0.0, 0.0]]), moontrace.BAD_CALL),
                           (lambda: page.samples([[0, 0]], out=numpy.zeros((2, 3))), moontrace.BAD_CALL),
                           (lambda: moontrace.Script("no such script"), moontrace.BAD_INPUT),
                           (lambda: moontrace.page("a\0b"), moontrace.BAD_INPUT),
                           (lambda: moontrace.page("moon", width=0.011), moontrace.BAD_INPUT),
                           (lambda: page.draw("/no/such/folder/a.svg"), moontrace.LACKING)):
            with self.assertRaises(moontrace.Error) as refused:
                call()
            self.assertEqual(refused.exception.code, code, refused.exception)
        with self.assertRaises(TypeError):
            moontrace.page("moon", colour="blue")

    def test_a_page_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "i.svg")
            page_of_an_i()[1].draw(path, print_letters=True)
            with open(path, encoding="utf-8") as picture:
                self.assertIn("A page in Moon", picture.read())


if __name__ == "__main__":
    unittest.main()

"""A program of somebody else in Python: the letters of a text, and how deep its grooves are."""

import moontrace

page = moontrace.page("moon")
print(moontrace.Script().title)
for letter in page.letters:
    print("%s at %.1f mm" % (letter.sign, 1000 * letter.x))
try:
    print("%.2f mm deep" % (-1000 * page.height_map(0.0002).min()))
except ImportError as error:
    print(error)

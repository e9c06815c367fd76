# One page of the HTML manual: cmake -DFROM=sim/README.md -DROOT=.. -DCMARK=cmark-gfm -DTO=FILE -P html_page.cmake
# FROM: a Markdown file of the source tree; ROOT: its way up to the tree's root, "" or "../".
execute_process(COMMAND ${CMARK} --extension table --unsafe ${FROM}
  OUTPUT_VARIABLE body COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "<h1>([^\n]*)</h1>" first "${body}")
string(REGEX REPLACE "<[^>]*>" "" title "${CMAKE_MATCH_1}")
# what is named in the text as a file is a page of the manual
string(REGEX REPLACE "<code>(OPTIONS|raw_protocol)\\.md</code>" "<a href=\"\\1.html\"><code>\\1</code></a>" body "${body}")
string(REGEX REPLACE "<code>(([a-z]+/)*)(README|OPTIONS|CONTRIBUTING|CHANGELOG|raw_protocol)\\.md</code>"
  "<a href=\"${ROOT}\\1\\3.html\"><code>\\1\\3</code></a>" body "${body}")
string(REGEX REPLACE "(<a href=\"[a-zA-Z_./]*)\\.md\"" "\\1.html\"" body "${body}")
file(WRITE ${TO} "<!DOCTYPE html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>${title}</title>
<style>
body { max-width: 50em; margin: 1em auto; padding: 0 1em; font: 1.1em/1.5 sans-serif; color: #111; background: #fff; }
pre { overflow-x: auto; } pre, code { font-size: 1em; } img { max-width: 100%; }
table { border-collapse: collapse; } th, td { border: 1px solid #666; padding: 0.2em 0.5em; text-align: left; }
</style>
</head>
<body>
<main>
${body}</main>
</body>
</html>
")

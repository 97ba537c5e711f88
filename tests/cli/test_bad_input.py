# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong is told in one line, with the place and what would mend it; nothing is written.

Each row: what is wrong, command line, files, standard input, and the line.
A scene of two boxes, boxes.scene, is always there.
"""

import shlex
import struct

import pytest
from program import run

# Contents of files that would be long to spell out.
GRAPH, HALF, INFO, BADEDGE, BADNUM, DEEP, WAD = "GRAPH", "HALF", "INFO", "BADEDGE", "BADNUM", "DEEP", "WAD"


def wad():
    """A map E1M1 of one line."""
    lumps = [(b"E1M1", b""), (b"LINEDEFS", struct.pack("<7H", 0, 1, 1, 0, 0, 0, 65535)),
             (b"VERTEXES", struct.pack("<4h", 0, 0, 9, 0))]
    content, directory = b"", b""
    for name, lump in lumps:
        directory += struct.pack("<2i8s", 12 + len(content), len(lump), name)
        content += lump
    return struct.pack("<4s2i", b"PWAD", len(lumps), 12 + len(content)) + content + directory


def content_of(word):
    """The bytes of a file in the table."""
    if word == WAD:
        return wad()
    if word == DEEP:
        return ("GEOMETRYCOLLECTION (" * 99 + "POINT (0 0)" + ")" * 99).encode()
    if word == INFO:
        return run("info", "boxes.scene", "-o", "-").out.encode()
    if word in (GRAPH, HALF, BADEDGE, BADNUM):
        graph = run("graph", "boxes.scene").out
        half = graph[:graph.index('"read"') + 3]
        wrong = {GRAPH: graph, HALF: half, BADEDGE: graph.replace("[0, 1]", "[0, 99]"),
                 BADNUM: graph.replace('"3"', '"three"')}
        return wrong[word].encode()
    return word.encode()


USAGE = [
    ("no command", "", {}, "",
     "sightline: A subcommand is required; see sightline --help"),
    ("unknown command", "grph boxes.scene", {}, "",
     "sightline: there is no command 'grph'; see sightline --help"),
    ("no scene", "graph", {}, "",
     "sightline graph: SCENE is required; see sightline graph --help"),
    ("unknown option", "graph boxes.scene --fast", {}, "",
     "sightline graph: The following argument was not expected: --fast; see sightline graph --help"),
    ("threads no number", "graph boxes.scene --threads two", {}, "",
     "sightline graph: --threads: Value two not in range 0 to 1024; see sightline graph --help"),
    ("threads negative", "graph boxes.scene --threads=-1", {}, "",
     "sightline graph: --threads: Value -1 not in range 0 to 1024; see sightline graph --help"),
    ("unknown arithmetic", "graph boxes.scene --arithmetic float", {}, "",
     "sightline graph: --arithmetic: float not in {filtered,exact,interval,double}; see sightline graph --help"),
    ("limit not positive", "graph boxes.scene --limit-seconds 0", {}, "",
     "sightline graph: --limit-seconds: '0' is no time; write seconds, as in 30 or 0.5; see sightline graph --help"),
    ("limit no number", "graph boxes.scene --limit-seconds soon", {}, "",
     "sightline graph: --limit-seconds: 'soon' is no time; write seconds, as in 30 or 0.5; see sightline graph --help"),
    ("no amount of memory", "graph boxes.scene --limit-memory lots", {}, "",
     "sightline graph: --limit-memory: 'lots' is no amount of memory; write bytes, or 512M, or 2G; see sightline graph --help"),
    ("unknown collinear rule", "graph boxes.scene --collinear some", {}, "",
     "sightline graph: --collinear: some not in {nearest,all}; see sightline graph --help"),
    ("partial where nothing is partial", "info boxes.scene --partial", {}, "",
     "sightline info: The following argument was not expected: --partial; see sightline info --help"),
    ("no viewpoint", "view2 boxes.scene", {}, "",
     "sightline: no viewpoint is named; give --from X,Y or --from-file"),
    ("viewpoint without comma", "view2 boxes.scene --from '1;2'", {}, "",
     "sightline: --from: '1;2' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("viewpoint without y", "view2 boxes.scene --from 1,", {}, "",
     "sightline: --from: '1,' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("viewpoint with z", "view2 boxes.scene --from 1,2,3", {}, "",
     "sightline: --from: '1,2,3' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("viewpoint over zero", "view2 boxes.scene --from 1/0,2", {}, "",
     "sightline: --from: '1/0,2' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("viewpoint nan", "view2 boxes.scene --from nan,2", {}, "",
     "sightline: --from: 'nan,2' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("huge exponent", "view2 boxes.scene --from 1e99999999,2", {}, "",
     "sightline: --from: '1e99999999,2' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("no end of the path", "path boxes.scene --from 2,2", {}, "",
     "sightline path: --to is required; see sightline path --help"),
    ("end of the path no point", "path boxes.scene --from 2,2 --to there", {}, "",
     "sightline: --to: 'there' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("box of three numbers", "view2 boxes.scene --from 2,2 --clip 0,0,9", {}, "",
     "sightline: --clip: '0,0,9' is no box; write X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1, as in -1,-1,5/2,3"),
    ("box inside out", "view2 boxes.scene --from 2,2 --clip 9,0,0,9", {}, "",
     "sightline: --clip: '9,0,0,9' is no box; write X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1, as in -1,-1,5/2,3"),
    ("viewpoint outside of the box", "view2 boxes.scene --from 2,2 --clip 0,0,1,1", {}, "",
     "sightline: --from 2,2: lies outside of the box of --clip; make the box larger"),
    ("added point too large", "graph boxes.scene --add 1e400,0", {}, "",
     "sightline: --add: '1e400,0' has a coordinate beyond the doubles; scale the scene"),
    ("no file of viewpoints", "view2 boxes.scene --from-file points.txt", {}, "",
     "sightline: points.txt: cannot be read (No such file or directory); check the name and the permissions"),
    ("bad line of viewpoints", "view2 boxes.scene --from-file points.txt", {"points.txt": "2,2\n\n3 3\n"}, "",
     "sightline: points.txt:3: '3 3' is no point; write X,Y with decimals or fractions, as in 1.5,-7/2"),
    ("no family", "generate", {}, "",
     "sightline: no family is named; see sightline generate --list"),
    ("unknown family", "generate dens -o out.scene", {}, "",
     "sightline: generate: there is no family 'dens'; the nearest are dense, dense-open or ring"),
    ("family parameter no number", "generate dense many -o out.scene", {}, "",
     "sightline: generate dense: N is 'many'; give a whole number from 3 to 10000000"),
    ("family parameter too small", "generate dense 2 -o out.scene", {}, "",
     "sightline: generate dense: N is '2'; give a whole number from 3 to 10000000"),
    ("too many family parameters", "generate dense 20 30 -o out.scene", {}, "",
     "sightline: generate dense: 2 parameters given; leave out all after the first 1"),
    ("seed no number", "generate dense 20 --seed luck -o out.scene", {}, "",
     "sightline generate: Could not convert: --seed = luck; see sightline generate --help"),
    ("ending without format", "generate dense 20 -o out.shp", {}, "",
     "sightline: out.shp: the ending tells no format; name a .wkt, .geojson, .json, .txt or .scene file"),
    ("3D scene in a 2D file", "generate cube -o out.wkt", {}, "",
     "sightline: out.wkt: 3D scenes are written as OFF; name a .off file"),
    ("2D scene in a 3D file", "generate dense 20 -o out.off", {}, "",
     "sightline: out.off: the ending tells no format; name a .wkt, .geojson, .json, .txt or .scene file"),
    ("parameter of a 3D family", "generate grid3 3 0 -o out.off", {}, "",
     "sightline: generate grid3: ROWS is '0'; give a whole number from 1 to 100"),
    ("unknown 3D family", "generate polytope -o out.off", {}, "",
     "sightline: generate: there is no family 'polytope'; the nearest are polytopes, polygons or holes"),
    ("family unknown to torture", "torture --family nothing", {}, "",
     "sightline: generate: there is no family 'nothing'; the nearest are tiny, chain or city"),
    ("output in no folder", "graph boxes.scene -o no/such/graph.json", {}, "",
     "sightline: no/such/graph.json: cannot be written (No such file or directory); give a file in a folder that exists and can be written"),
    ("output is a folder", "graph boxes.scene -o .", {}, "",
     "sightline: .: is a folder; give the name of a file"),
    ("output without a name", "graph boxes.scene -o ''", {}, "",
     "sightline graph: --output: the name is empty; see sightline graph --help"),
    ("output is the scene", "graph boxes.scene -o ./boxes.scene", {}, "",
     "sightline: ./boxes.scene: is read from; give the output another name"),
    ("two outputs in one file", "graph boxes.scene -o out --svg out", {}, "",
     "sightline: out: would be written twice; give each output a file of its own"),
    ("standard input twice", "graph - -", {}, "",
     "sightline: standard input (-) is named twice; it can be read only once"),
    ("render nothing", "render boxes.scene", {}, "",
     "sightline: no picture is named; give --png, --svg or --vtk a file"),
    ("render by unknown ending", "render boxes.scene -o out.jpg", {}, "",
     "sightline: out.jpg: the ending tells no picture; name a .svg, .png, .vtp or .vtm file"),
    ("render without scene", "render graph.json --svg out.svg", {"graph.json": GRAPH}, "",
     "sightline: only results are named; name their scene too"),
    ("render another scene", "render one.scene graph.json --svg out.svg", {"graph.json": GRAPH, "one.scene": "polygon 0 0, 1 0, 0 1\n"}, "",
     "sightline: graph.json: is of a scene with 8 vertices, this one has 3; name the files that it was made from"),
]

RESULTS = [
    ("no result file", "check graph.json boxes.scene", {}, "",
     "sightline: graph.json: cannot be read (No such file or directory); check the name and the permissions"),
    ("a scene as result", "check boxes.scene boxes.scene", {}, "",
     "sightline: boxes.scene: is no result of sightline (parse error at line 1, column 1: syntax error while parsing value - invalid literal; last read: 'p'); write it again"),
    ("half a result", "check graph.json boxes.scene", {"graph.json": HALF}, "",
     "sightline: graph.json: is no result of sightline (parse error at line 7, column 20: syntax error while parsing object key - invalid string: missing closing quote; last read: '\"re'; expected string literal); write it again"),
    ("result of unknown kind", "check info.json boxes.scene", {"info.json": INFO}, "",
     "sightline: info.json: there is no reference for the kind 'info'; name a graph, view, path or skeleton"),
    ("edge of no vertices", "check graph.json boxes.scene", {"graph.json": BADEDGE}, "",
     "sightline: graph.json: is no result of sightline ([0, 99] is no edge); write it again"),
    ("coordinate that is no number", "check graph.json boxes.scene", {"graph.json": BADNUM}, "",
     "sightline: graph.json: is no result of sightline ('three' is no exact number); write it again"),
    ("result of another scene", "check graph.json one.scene", {"graph.json": GRAPH, "one.scene": "polygon 0 0, 1 0, 0 1\n"}, "",
     "sightline: graph.json: is of a scene with 8 vertices, this one has 3; name the files that it was made from"),
]

SCENES = [
    ("missing", "info missing.wkt", {}, "",
     "sightline: missing.wkt: cannot be read (No such file or directory); check the name and the permissions"),
    ("folder", "info .", {}, "",
     "sightline: .: cannot be read (Is a directory); check the name and the permissions"),
    ("empty", "info a.wkt", {"a.wkt": ""}, "",
     "sightline: a.wkt: the scene is empty; give at least one polygon, wall or point"),
    ("nothing in it", "info a.wkt", {"a.wkt": "GEOMETRYCOLLECTION EMPTY"}, "",
     "sightline: a.wkt: the scene is empty; give at least one polygon, wall or point"),
    ("unknown word", "info a.wkt", {"a.wkt": "POLYGONE ((0 0, 1 0, 0 1))"}, "",
     "sightline: a.wkt:1:9: 'POLYGONE' is no geometry; write POLYGON, LINESTRING or POINT"),
    ("not closed", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 0, 0 1"}, "",
     "sightline: a.wkt:1:24: expected ')', but the text ends"),
    ("no number", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 0,\n zero 1))"}, "",
     "sightline: a.wkt:2:2: expected a number, found 'zero'"),
    ("no comma", "info a.wkt", {"a.wkt": "POLYGON ((0 0; 1 0; 0 1))"}, "",
     "sightline: a.wkt:1:14: expected ',' or ')', found ';'"),
    ("infinite", "info a.wkt", {"a.wkt": "POLYGON ((0 0, inf 0, 0 1))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, vertex 1 (inf, 0): is not finite; give a number for each coordinate"),
    ("too large", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1e999 0, 0 1))"}, "",
     "sightline: a.wkt:1:16: the number is beyond the doubles; give one below 2^1020 in size"),
    ("three coordinates", "info a.wkt", {"a.wkt": "POLYGON Z ((0 0 1, 1 0 1, 0 1 1))"}, "",
     "sightline: a.wkt:1:10: POLYGON Z has more than two coordinates; give x and y only"),
    ("curve", "info a.wkt", {"a.wkt": "CIRCULARSTRING (0 0, 1 1, 2 0)"}, "",
     "sightline: a.wkt:1:15: CIRCULARSTRING is not supported; write it as POLYGON or LINESTRING"),
    ("deep", "info a.wkt", {"a.wkt": DEEP}, "",
     "sightline: a.wkt:1:1300: collections are nested deeper than 64; flatten them"),
    ("two vertices", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 0, 0 0))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring: a ring needs at least 3 distinct vertices; add vertices or remove the ring"),
    ("repeated vertex", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 0, 1 0, 0 1))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, vertex 2 (1, 0): repeats the vertex before it; remove one of the two, or use --repair"),
    ("spike", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 2 0, 1 0, 0 1))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, vertex 1 (2, 0): is a spike: the ring turns back on itself; remove the vertex, or use --repair"),
    ("crosses itself", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 1, 1 0, 0 1))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(1, 1) crosses element 0 (polygon), outer ring, edge 2 (1, 0)-(0, 1): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"),
    ("hole outside", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 1 0, 0 1), (5 5, 6 5, 5 6))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), hole 0, vertex 0 (5, 5): the hole is not inside its polygon's outer ring; move it, or make it a polygon of its own"),
    ("hole crosses", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 4 0, 0 4), (1 1, 9 1, 1 2))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, edge 1 (4, 0)-(0, 4) crosses element 0 (polygon), hole 0, edge 1 (9, 1)-(1, 2): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"),
    ("overlap", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 4 0, 0 4))\nPOLYGON ((1 1, 9 1, 1 9))"}, "",
     "sightline: a.wkt:2: element 1 (polygon), outer ring, vertex 0 (1, 1): lies inside body 0: bodies 0 and 1 overlap; separate them, or merge them with --repair"),
    ("nested", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 9 0, 0 9))\nPOLYGON ((1 1, 2 1, 1 2))"}, "",
     "sightline: a.wkt:2: element 1 (polygon), outer ring, vertex 0 (1, 1): body 1 lies inside the solid part of body 0; remove it, or merge them with --repair"),
    ("wall of no length", "info a.wkt", {"a.wkt": "LINESTRING (1 1, 1 1)"}, "",
     "sightline: a.wkt:1: element 0 (wall), vertex 1 (1, 1): ends a wall of length zero; remove the vertex, or use --repair"),
    ("wall through a body", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 4 0, 0 4))\nLINESTRING (-1 1, 9 1)"}, "",
     "sightline: a.wkt:2: element 1 (wall), edge 0 (-1, 1)-(9, 1): the wall runs through the interior of body 0; cut it at the body's boundary"),
    ("point in a body", "info a.wkt", {"a.wkt": "POLYGON ((0 0, 4 0, 0 4))\nPOINT (1 1)"}, "",
     "sightline: a.wkt:2: element 1 (point), vertex 0 (1, 1): the point lies inside body 0; move or remove it"),
    ("world without polygon", "info a.wkt --world", {"a.wkt": "POINT (1 1)"}, "",
     "sightline: a.wkt: there is no polygon to be the world; add one, or read without the world option"),
    ("out of the world", "info a.wkt --world", {"a.wkt": "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((3 3, 9 3, 3 9))"}, "",
     "sightline: a.wkt:1: element 0 (polygon), outer ring, edge 2 (4, 4)-(0, 4) crosses element 1 (polygon), outer ring, edge 2 (3, 9)-(3, 3): body 0 reaches out of the world; clip it to the world"),
    ("json cut off", "info a.geojson", {"a.geojson": "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0]"}, "",
     "sightline: a.geojson:1:48: not JSON: the text ends too early; complete it"),
    ("json of another kind", "info a.geojson", {"a.geojson": "{\"type\": \"Topology\", \"objects\": {}}"}, "",
     "sightline: a.geojson:1:35: type \"Topology\" is not supported; write Polygon, LineString or Point"),
    ("json with words for numbers", "info a.geojson", {"a.geojson": "{\"type\": \"Point\", \"coordinates\": [\"a\", \"b\"]}"}, "",
     "sightline: a.geojson:1:37: a text stands among the coordinates; write numbers"),
    ("json without type", "info a.geojson", {"a.geojson": "{\"coordinates\": [1, 2]}"}, "",
     "sightline: a.geojson:1:23: an object has no type; add \"type\""),
    ("text with an unknown word", "info a.scene", {"a.scene": "polygon 0 0, 1 0, 0 1\npolygone 3 3, 4 3, 3 4\n"}, "",
     "sightline: a.scene:2:9: 'polygone' is no word of a scene; write polygon, hole, wall, point or world"),
    ("hole of nothing", "info a.scene", {"a.scene": "hole 0 0, 1 0, 0 1\n"}, "",
     "sightline: a.scene:1:5: 'hole' does not follow a polygon; put it below its polygon's line"),
    ("text with half a point", "info a.scene", {"a.scene": "polygon 0 0, 1, 0 1\n"}, "",
     "sightline: a.scene:1:15: expected a number, found ','"),
    ("binary", "info a.wkt", {"a.wkt": "\0\x01\x02"}, "",
     "sightline: a.wkt:1:1: expected a geometry such as POLYGON, found '\\x00\\x01\\x02'"),
    ("fault in the second file", "info boxes.scene a.scene", {"a.scene": "\n\npolygon 10 0, 11 1, 11 0, 10 1\n"}, "",
     "sightline: a.scene:3: element 0 (polygon), outer ring, edge 0 (10, 0)-(11, 1) crosses element 0 (polygon), outer ring, edge 2 (11, 0)-(10, 1): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"),
    ("fault between two files", "info boxes.scene a.scene", {"a.scene": "polygon 3.5 0.5, 9 0.5, 9 3\n"}, "",
     "sightline: boxes.scene + a.scene: element 2 (polygon), outer ring, vertex 0 (3.5, 0.5): lies inside body 1: bodies 1 and 2 overlap; separate them, or merge them with --repair"),
    ("world in the second file", "info boxes.scene a.scene", {"a.scene": "world\npolygon -9 -9, 9 -9, 9 9, -9 9\n"}, "",
     "sightline: a.scene: only the first file may be a world; name it first"),
    ("fault on standard input", "info -", {}, "POLYGON ((0 0, 1 0))",
     "sightline: standard input:1: element 0 (polygon), outer ring: a ring needs at least 3 distinct vertices; add vertices or remove the ring"),
    ("no wad", "info doom.wad:E1M1", {}, "",
     "sightline: doom.wad: cannot be read; check the path and its permissions"),
    ("bogus wad", "info doom.wad:E1M1", {"doom.wad": "JUNKJUNKJUNK"}, "",
     "sightline: doom.wad: not a WAD (no IWAD or PWAD at the start); give a Doom WAD file"),
    ("wad without map name", "info doom.wad", {"doom.wad": WAD}, "",
     "sightline: doom.wad: which map? Write doom.wad:MAP with one of E1M1"),
    ("wad without that map", "info doom.wad:E9M9", {"doom.wad": WAD}, "",
     "sightline: doom.wad: there is no map 'E9M9'; give one of E1M1"),
]

FAR = [
    ("view from beyond the doubles", "view2 boxes.scene --from 1e400,1", {}, "",
     "sightline: --from 1e400,1: a coordinate of the point is larger than 2^1020; choose a nearer point"),
    ("view from the last doubles", "view2 boxes.scene --from 1,-1.7e308", {}, "",
     "sightline: --from 1,-1.7e308: a coordinate of the point is larger than 2^1020; choose a nearer point"),
    ("path to beyond the doubles", "path boxes.scene --from 9,9 --to 1,1e310", {}, "",
     "sightline: a coordinate of the point is larger than 2^1020; choose a nearer point"),
]

NO_ANSWER = [
    ("view from inside a body", "view2 boxes.scene --from 1/2,1/2", {}, "",
     "sightline: --from 1/2,1/2: point (1/2, 1/2) lies inside body 0; choose a point outside the bodies"),
    ("view from outside of the world", "view2 room.scene --from 9,9", {"room.scene": "world\npolygon 0 0, 4 0, 4 4, 0 4\n"}, "",
     "sightline: --from 9,9: point (9, 9) lies outside the world; choose a point inside its boundary"),
    ("path from inside a body", "path boxes.scene --from 1/2,1/2 --to 9,9", {}, "",
     "sightline: point (1/2, 1/2) lies inside body 0; choose a point outside the bodies"),
    ("path to outside of the world", "path room.scene --from 1,1 --to 9,9", {"room.scene": "world\npolygon 0 0, 4 0, 4 4, 0 4\n"}, "",
     "sightline: point (9, 9) lies outside the world; choose a point inside its boundary"),
    ("added point inside a body", "graph boxes.scene --add 2,2 --add 1/2,1/2", {}, "",
     "sightline: point (0.5, 0.5) lies inside body 0; choose one outside"),
]


def check(folder, case, status):
    _, command, files, stdin, line = case
    for name, content in files.items():
        (folder / name).write_bytes(content_of(content))
    before = {p.name: p.read_bytes() for p in folder.iterdir()}
    finished = run(*shlex.split(command), stdin=stdin)
    assert (finished.status, finished.out, finished.err) == (status, "", line + "\n")
    assert {p.name: p.read_bytes() for p in folder.iterdir()} == before


@pytest.mark.parametrize("case", USAGE, ids=lambda case: case[0])
def test_usage(folder, case):
    check(folder, case, 2)


@pytest.mark.parametrize("case", RESULTS, ids=lambda case: case[0])
def test_results(folder, case):
    check(folder, case, 2)


@pytest.mark.parametrize("case", SCENES, ids=lambda case: case[0])
def test_scenes(folder, case):
    check(folder, case, 2)


@pytest.mark.parametrize("case", FAR, ids=lambda case: case[0])
def test_far(folder, case):
    check(folder, case, 2)


@pytest.mark.parametrize("case", NO_ANSWER, ids=lambda case: case[0])
def test_no_answer(folder, case):
    check(folder, case, 1)

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of a result file as a Markdown table: markdown.py RESULTS.csv [COLUMN…]"""

import csv
import sys


def main():
    with open(sys.argv[1]) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    columns = sys.argv[2:] or list(rows[0])
    print("| " + " | ".join(columns) + " |")
    print("| " + " | ".join("---" for _ in columns) + " |")
    for row in rows:
        print("| " + " | ".join(row[column] or "–" for column in columns) + " |")


if __name__ == "__main__":
    main()

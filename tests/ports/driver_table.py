"""What ran on which of the kernel's drivers: a table of the reports that GoogleTest writes (--gtest_output=json), whose tests name
the drivers of their ports and controllers (driver.hpp)."""
import collections
import json

PROPERTY = "kernel_drivers"


def tests_of(report):
    for suite in report["testsuites"]:
        for test in suite["testsuite"]:
            if test.get("status") == "RUN":
                yield test


def report_of(path):
    """The file's report; none where the machine ended amid it."""
    try:
        return json.loads(path.read_text())
    except ValueError:
        return {"testsuites": []}


def outcome(test):
    return "failed" if "failures" in test else "passed"


def table(paths):
    """One row for each driver and fixture, with the number of its tests; empty if no test named a driver."""
    rows = collections.defaultdict(collections.Counter)
    for path in paths:
        for test in tests_of(report_of(path)):
            for driver in filter(None, test.get(PROPERTY, "").split(" ")):
                fixture = test["classname"].split("/")[-1]
                rows[driver, fixture, test["name"].split("/")[0]][outcome(test)] += 1
    if not rows:
        return ""
    width = max(len(driver) for driver, _, _ in rows)
    lines = [f"{'kernel driver':{max(width, 13)}}  passed  failed  test"]
    for (driver, fixture, name), count in sorted(rows.items()):
        lines.append(f"{driver:{max(width, 13)}}  {count['passed']:6}  {count['failed']:6}  {fixture}.{name}")
    return "\n".join(lines) + "\n"

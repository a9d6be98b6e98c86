"""Plants one loss after the other in a small ledger, which is sound without them, and asks whether it is named."""

import pathlib
import tempfile
import unittest

import findings
import ledger
import passed_over
from page import page

CLAIM = ledger.Claim("protocols", ("pd0",), "its ranges", ("others",), ("Pd0.RangesHave24Bits",), "protocols.toml: claim 1")
OTHERS = ledger.Witness("others", "captures", "a dive", "owner/name", "0123abcd", "MIT", ("dvl/*.pd0",), ("dvl/LICENSE",))
# sha256sum of the three letters "abc": FIPS 180-2, appendix B.1
ABC = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
SUMS = {"dvl/dive.pd0": ABC, "dvl/LICENSE": ABC}


class Names(unittest.TestCase):
    def test_nothing_is_found_where_claims_and_witnesses_name_each_other(self):
        self.assertEqual(list(findings.of_names([CLAIM], [OTHERS])), [])

    def test_a_witness_that_nobody_calls_is_named(self):
        alone = ledger.Witness("alone", "programs", "a reader")
        self.assertEqual(list(findings.of_names([CLAIM], [OTHERS, alone])), ["programs.toml: no claim calls the witness alone"])

    def test_a_claim_whose_witness_is_gone_is_named(self):
        self.assertEqual(list(findings.of_names([CLAIM], [])), ["protocols.toml: claim 1: there is no witness others"])

    def test_a_protocol_without_a_claim_is_named(self):
        self.assertEqual(list(findings.of_coverage([CLAIM], {"protocols": {"pd0", "pd4"}})),
                         ["claims/protocols.toml: the program knows pd4, and no claim is about it"])

    def test_a_claim_about_a_protocol_that_is_gone_is_named(self):
        self.assertEqual(list(findings.of_coverage([CLAIM], {"protocols": set()})),
                         ["claims/protocols.toml: a claim is about pd0, which is not there"])


class Tests(unittest.TestCase):
    def found(self, test):
        return list(findings.of_tests([CLAIM], [test]))

    def test_a_test_of_ctest_is_known_whole_and_without_its_parameters(self):
        for test in ("Pd0.RangesHave24Bits", "All/Pd0.RangesHave24Bits/short", "Pd0.RangesHave24Bits<drydock::wire::Pd0>",
                     "Pd0.RangesHave24Bits<Pd0/pd0.  # TypeParam = drydock::wire::Pd0>"):
            self.assertEqual(self.found(test), [], test)

    def test_a_test_that_is_gone_or_renamed_is_named(self):
        for test in ("Pd0.RangesHave24BitsNow", "XPd0.RangesHave24Bits"):
            self.assertEqual(self.found(test), ["protocols.toml: claim 1: ctest has no test Pd0.RangesHave24Bits"], test)

    def test_a_program_of_tests_that_is_not_built_is_named(self):
        self.assertIn("not built, so their tests are not known: wire_test_NOT_BUILT", self.found("wire_test_NOT_BUILT"))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("dvl/dive.pd0", "abc")
        self.write("dvl/LICENSE", "abc")

    def write(self, name, text):
        (self.root / name).parent.mkdir(exist_ok=True)
        (self.root / name).write_text(text)

    def found(self, sums):
        return list(findings.of_files([OTHERS], self.root, sums, "captures.sha256")) + list(findings.of_strays([OTHERS], self.root))

    def test_nothing_is_found_where_the_sums_fit(self):
        self.assertEqual(self.found(SUMS), [])

    def test_a_file_with_one_other_byte_is_named(self):
        self.write("dvl/dive.pd0", "abd")
        self.assertIn("its SHA-256 is not that of captures.sha256", self.found(SUMS)[0])

    def test_a_file_that_is_lost_is_named(self):
        self.assertEqual(self.found(SUMS | {"dvl/next.pd0": ABC}),
                         ["captures.sha256: dvl/next.pd0 is lost, or no witness has it"])

    def test_a_capture_of_nobody_is_named(self):
        self.write("dvl/own.bin", "")
        self.assertEqual(self.found(SUMS),
                         ["dvl/own.bin: a capture without a witness; give it a row in captures.toml"])

    def test_a_pattern_that_no_file_has_is_named(self):
        (self.root / "dvl/LICENSE").unlink()
        self.assertEqual(self.found(SUMS), ["captures.toml: others: no file is dvl/LICENSE",
                                            "captures.sha256: dvl/LICENSE is lost, or no witness has it"])


class Packages(unittest.TestCase):
    def found(self, witness, version="3.22-4.1+deb12u1"):
        return list(findings.of_packages([witness], {"gpsd"}, {"packages": {}}, lambda package: version))

    def test_a_later_edition_of_the_same_version_is_the_same_witness(self):
        self.assertEqual(self.found(ledger.Witness("gpsd", "programs", "", package="gpsd", version="3.22")), [])

    def test_another_version_is_another_witness(self):
        self.assertEqual(self.found(ledger.Witness("gpsd", "programs", "", package="gpsd", version="3.22"), "1:3.25-1"),
                         ["programs.toml: gpsd: gpsd is 1:3.25-1, the witness was 3.22"])

    def test_a_package_that_ci_does_not_install_is_named(self):
        self.assertEqual(self.found(ledger.Witness("t", "programs", "", package="tshark", version="4"), None),
                         ["programs.toml: t: .ci installs no package tshark"])
        self.assertEqual(self.found(ledger.Witness("m", "programs", "", npm="@mcap/core")),
                         ["programs.toml: m: tests/npm/package-lock.json has no @mcap/core"])


class PassedOver(unittest.TestCase):
    JUNIT = """<testsuite>
<testcase name="All/Pd0.RangesHave24Bits/a" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
<system-out>[ RUN ]\n/x/y_test.cpp:7: Skipped\nno captures at "/x"\n</system-out></testcase>
<testcase name="Vcan.Opens" status="notrun"><skipped message=""/><system-out>/x/v.cpp:9: Skipped\nno kernel module\n</system-out></testcase>
<testcase name="Peer.Reads" status="notrun"><skipped message=""/><system-out>tshark is not installed\n</system-out></testcase>
<testcase name="Ports.Opens" status="run"><system-out>P.Q: passed at the second run only
The first run:
</system-out></testcase>
<testcase name="Other.Runs" status="run"/></testsuite>"""

    def setUp(self):
        with tempfile.NamedTemporaryFile("w", delete=False) as file:
            file.write(self.JUNIT)
        self.addCleanup(pathlib.Path(file.name).unlink)
        self.cases = list(passed_over.skipped(file.name))
        self.late = list(passed_over.late(file.name))

    def test_each_skipped_check_is_counted_with_its_reason(self):
        named = passed_over.tests_by_claim([CLAIM], [OTHERS], here=False)
        reasons, lost = passed_over.summary(self.cases, named)
        self.assertEqual(dict(reasons), {passed_over.ABSENT: 1, "no kernel module": 1, "tshark is not installed": 1})
        self.assertEqual(lost, 1)

    def test_beside_captures_the_tests_own_reason_counts(self):
        reasons, _ = passed_over.summary(self.cases, passed_over.tests_by_claim([CLAIM], [OTHERS], here=True))
        self.assertEqual(reasons['no captures at "/x"'], 1)

    def test_what_passed_at_its_second_run_only_is_said(self):
        self.assertEqual(self.late, ["P.Q: passed at the second run only"])

    def test_ci_needs_every_witness_where_captures_are_or_are_named(self):
        must = passed_over.every_witness_must_be_heard
        self.assertTrue(must({"CI": "true"}, here=True))
        self.assertTrue(must({"CI": "true", "DRYDOCK_CORPORA": "/absent"}, here=False))
        self.assertFalse(must({"CI": "true"}, here=False))
        self.assertFalse(must({"DRYDOCK_CORPORA": "/absent"}, here=False))


class Page(unittest.TestCase):
    def test_a_single_file_is_shown_with_its_own_sum(self):
        text = page([CLAIM], [OTHERS], {"dvl/dive.pd0": ABC}, {}, {"packages": {}})
        self.assertIn(f"| `others` | a dive | owner/name | 0123abcd | MIT | 1 | 0 | `{ABC}` |", text)
        self.assertIn("| `pd0` | its ranges | `others` | `Pd0.RangesHave24Bits` |", text)


if __name__ == "__main__":
    unittest.main()

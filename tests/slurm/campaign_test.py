#!/usr/bin/env python3
"""Campaigns by a real Slurm on this machine: campaign_test.py DRYDOCK. A node dies, a disk is full, memory runs out, somebody
cancels: nothing is lost and nothing counts twice, and the results have the bytes of a run without any of it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
from cluster import Cluster, wait_until  # noqa: E402

DRYDOCK = ""

FILE = """
[campaign]
name = "test"
command = "sh {{file:run.sh}}"
repetitions = {runs}
[[parameter]]
name = "x"
normal = [0.0, 1.0]
[[file]]
name = "run.sh"
text = '''
{shell}
echo '{{"y": {{x}}}}'
'''
[[figure]]
name = "y"
at = "/y"
"""


class Campaign:
    """A campaign in a folder of its own. `shell` runs before each run's figure is printed; it may depend on the machine."""

    def __init__(self, cluster, folder, runs, shell=""):
        self.cluster, self.folder, self.runs = cluster, pathlib.Path(folder), runs
        self.file, self.out = self.folder / "c.toml", self.folder / "out"
        self.file.write_text(FILE.format(runs=runs, shell=shell))

    def words(self, *more):
        return [DRYDOCK, "campaign", str(self.file), "--out", str(self.out), *more]

    def run(self, *more):
        return self.cluster.run(*self.words(*more))

    def by_slurm(self, *more, shard_runs=5):
        return self.run("--engine", "slurm", "--shard-runs", str(shard_runs), *more)

    def started(self, *more, shard_runs=5):
        return subprocess.Popen(self.words("--engine", "slurm", "--shard-runs", str(shard_runs), *more),
                                env=self.cluster.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def undisturbed(self):
        """The results of the same runs in one process. They do not depend on what the shell waits for."""
        out = self.folder / "alone"
        self.cluster.run(DRYDOCK, "campaign", str(self.file), "--out", str(out), "--jobs", "1")
        return (out / "results.sqlite").read_bytes()

    def results(self):
        return (self.out / "results.sqlite").read_bytes()

    def done(self):
        return sum(path.read_text().count("\n") for path in self.out.glob("runs/*.journal"))


@unittest.skipUnless(os.geteuid() == 0, "needs root, who may start the daemons of a cluster")
class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not (shutil.which("slurmctld") and shutil.which("munged")):
            absent = "slurm-wlm or munge is missing (.ci/packages-peers.txt)"
            raise AssertionError(absent) if os.environ.get("CI") == "true" else unittest.SkipTest(absent)
        cls.room = tempfile.TemporaryDirectory(prefix="drydock-slurm-")
        cls.cluster = Cluster(cls.room.name).__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.cluster.__exit__()
        cls.room.cleanup()

    def setUp(self):
        self.folder = tempfile.mkdtemp(dir=self.room.name)

    def campaign(self, runs, shell=""):
        return Campaign(self.cluster, self.folder, runs, shell)

    def test_one_process_sixteen_threads_and_forty_tasks_give_the_same_bytes(self):
        campaign = self.campaign(80)
        said = campaign.by_slurm(shard_runs=2)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertEqual(len(list(campaign.out.glob("runs/shard-1-*.journal"))), 40)
        threads = pathlib.Path(self.folder, "threads")
        self.cluster.run(DRYDOCK, "campaign", str(campaign.file), "--out", str(threads), "--jobs", "16")
        alone = campaign.undisturbed()
        self.assertEqual(campaign.results(), alone)
        self.assertEqual((threads / "results.sqlite").read_bytes(), alone)
        for name in ("summary.json", "index.html"):
            self.assertEqual((campaign.out / name).read_bytes(), (threads / name).read_bytes(), name)

    def test_a_node_that_dies_in_the_middle_loses_nothing_and_counts_nothing_twice(self):
        marks = pathlib.Path(self.folder, "begun")
        marks.mkdir()
        campaign = self.campaign(48, f"echo x >> {marks}/{{index}}; [ -e {marks}/fast ] || sleep 0.5")
        process = campaign.started(shard_runs=4)
        wait_until("the campaign is on its way", lambda: campaign.done() >= 6)
        busy = max(self.cluster.nodes, key=lambda node: len(self.cluster.steps_of(node)))
        self.assertGreater(self.cluster.kill_node(busy), 0, "the node had work")
        output, errors = process.communicate(timeout=180)
        self.cluster.start_node(busy)
        self.assertEqual(process.returncode, 0, output + errors)
        begun = [(marks / str(i)).read_text().count("x") for i in range(48)]
        self.assertGreater(sum(begun), 48, "some runs began again")
        (marks / "fast").touch()
        self.assertEqual(campaign.results(), campaign.undisturbed())
        wait_until("the node is back", lambda: self.cluster.states() == {"idle"})

    def test_a_task_that_runs_out_of_memory_costs_its_own_runs_and_no_others(self):
        once = pathlib.Path(self.folder, "once")
        campaign = self.campaign(20, f"if [ {{index}} = 7 ] && mkdir {once} 2>/dev/null; then "
                                     "exec /usr/bin/python3 -c 'x = bytearray(400 << 20); import time; time.sleep(60)'; fi")
        said = campaign.by_slurm("--sbatch", "--mem=100")
        self.assertEqual(said.returncode, 1, said.stdout)
        missing = int(re.search(r"(\d+) are missing", said.stderr)[1])
        self.assertIn(missing, range(1, 4), "runs 7, 8 and 9 of its shard at most")
        self.assertEqual(campaign.run("--resume").returncode, 0)
        self.assertEqual(campaign.results(), campaign.undisturbed())

    def test_a_full_disk_is_said_and_what_was_done_stays(self):
        campaign = self.campaign(60)
        campaign.out.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=48k", "none", str(campaign.out)]).returncode != 0:
            self.skipTest("a small disk cannot be mounted here")
        try:
            said = campaign.by_slurm()
            self.assertEqual(said.returncode, 1, said.stdout + said.stderr)
            kept = campaign.done()
            self.assertGreater(kept, 0)
            self.assertLess(kept, 60)
            subprocess.run(["mount", "-o", "remount,size=8m", str(campaign.out)], check=True)
            said = campaign.by_slurm("--resume")
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertEqual(campaign.done(), 60, "no run was done twice")
            self.assertEqual(campaign.results(), campaign.undisturbed())
        finally:
            subprocess.run(["umount", str(campaign.out)], check=True)

    def test_a_campaign_is_cancelled_and_goes_on(self):
        fast = pathlib.Path(self.folder, "fast")
        campaign = self.campaign(30, f"[ -e {fast} ] || [ {{index}} -lt 6 ] || sleep 600")
        self.assertIn("submitted 30 runs as job", campaign.by_slurm("--detach", shard_runs=3).stdout)
        wait_until("six runs are done", lambda: campaign.done() == 6)
        status = campaign.run("--status").stdout
        self.assertIn("6 of 30 runs, 0 failed", status)
        self.assertRegex(status, r"Slurm: \d+ tasks RUNNING")
        again = campaign.by_slurm("--resume")
        self.assertIn("are still in Slurm's queue", again.stderr)
        self.assertEqual(campaign.run("--cancel").returncode, 0)
        wait_until("all tasks are gone", lambda: "all tasks have ended" in campaign.run("--status").stdout)
        fast.touch()
        self.assertEqual(campaign.by_slurm("--resume").returncode, 0)
        self.assertEqual(campaign.done(), 30)
        self.assertEqual(campaign.results(), campaign.undisturbed())

    def test_ctrl_c_ends_the_tasks_and_merges_what_they_did(self):
        fast = pathlib.Path(self.folder, "fast")
        campaign = self.campaign(12, f"[ -e {fast} ] || [ {{index}} -lt 4 ] || sleep 600")
        process = campaign.started(shard_runs=2)
        wait_until("four runs are done", lambda: campaign.done() == 4)
        begun = time.monotonic()
        process.send_signal(2)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, output)
        self.assertIn("8 are missing", errors)
        self.assertLess(time.monotonic() - begun, 60)
        wait_until("all tasks are gone", lambda: "all tasks have ended" in campaign.run("--status").stdout)
        self.assertTrue((campaign.out / "results.sqlite").exists())


if __name__ == "__main__":
    DRYDOCK = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)

"""A real Slurm on this machine alone: munge, slurmctld and several slurmd, all in one folder."""

import os
import pathlib
import signal
import socket
import subprocess
import time

CONFIG = """
ClusterName=drydock
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.sock
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=1000,batch_sched_delay=0,default_queue_depth=1000,requeue_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
DefMemPerCPU=200
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmctldPort={port}
SlurmdTimeout=10
KillWait=2
BatchStartTimeout=10
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=task=1
JobAcctGatherParams=OverMemoryKill
JobCompType=jobcomp/none
MaxArraySize=20001
MaxJobCount=30000
SlurmdParameters=config_overrides
{nodes}
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def wait_until(what, true, seconds=60):
    end = time.monotonic() + seconds
    while not true():
        if time.monotonic() > end:
            raise TimeoutError(what)
        time.sleep(0.2)


class Cluster:
    """Ends with everything that it started."""

    def __init__(self, folder, nodes=3, cpus=2, port=16900):
        self.folder, self.nodes = pathlib.Path(folder), [f"n{i}" for i in range(1, nodes + 1)]
        self.folder.chmod(0o755)
        self.daemons = {}
        (self.folder / "state").mkdir()
        lines = [f"NodeName={n} NodeHostname={socket.gethostname()} NodeAddr=127.0.0.1 Port={port + 1 + i} "
                 f"CPUs={cpus} RealMemory=4000 State=UNKNOWN" for i, n in enumerate(self.nodes)]
        config = self.folder / "slurm.conf"
        config.write_text(CONFIG.format(host=socket.gethostname(), folder=self.folder, port=port, nodes="\n".join(lines)))
        # Nothing here uses cgroups; but only the old kind lets slurmd start where none are mounted, as in a chroot.
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        self.environment = {**os.environ, "SLURM_CONF": str(config)}

    def __enter__(self):
        try:
            self.start_munge()
            self.start("slurmctld", "slurmctld", "-c", "-D")
            for node in self.nodes:
                self.start_node(node)
            wait_until("nodes are idle", lambda: self.states() == {"idle"})
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for node in self.nodes:
            self.kill(self.steps_of(node))
        for name in reversed(list(self.daemons)):
            self.end(name, signal.SIGTERM)

    def start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        self.start("munged", "munged", "--foreground", "--force", f"--key-file={key}",
                   *(f"--{what}={self.folder}/munge{ending}" for what, ending in
                     (("socket", ".sock"), ("pid-file", ".pid"), ("seed-file", ".seed"), ("log-file", ".log"))))
        wait_until("munge answers", (self.folder / "munge.sock").exists)

    def start(self, name, *words):
        with open(self.folder / f"{name}.out", "ab") as log:
            self.daemons[name] = subprocess.Popen(words, env=self.environment, stdout=log, stderr=log, start_new_session=True)

    def start_node(self, node):
        (self.folder / f"spool-{node}").mkdir(exist_ok=True)
        self.start(node, "slurmd", "-D", "-N", node)

    def end(self, name, how):
        process = self.daemons.pop(name)
        process.send_signal(how)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def kill_node(self, node):
        """As a power cut does: slurmd and what runs under it are gone at once."""
        steps = self.steps_of(node)
        self.end(node, signal.SIGKILL)
        self.kill(steps)
        return len(steps)

    @staticmethod
    def kill(pids):
        for pid in pids:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def steps_of(self, node):
        """The step managers that the node's slurmd started, and all that they started."""
        parents = {}
        for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
            try:
                fields = stat.read_text().rsplit(")", 1)[1].split()
            except (FileNotFoundError, ProcessLookupError):
                continue
            parents[int(stat.parent.name)] = int(fields[1])
        mine = {pid for pid in parents if self.is_step(pid, node)}
        while True:
            more = {pid for pid, parent in parents.items() if parent in mine} - mine
            if not more:
                return mine
            mine |= more

    def is_step(self, pid, node):
        """A step manager keeps a socket in its node's spool folder open."""
        try:
            if not pathlib.Path(f"/proc/{pid}/comm").read_text().startswith("slurmstepd"):
                return False
            environment = pathlib.Path(f"/proc/{pid}/environ").read_bytes()
        except (FileNotFoundError, ProcessLookupError):
            return False
        sockets = pathlib.Path(self.folder / f"spool-{node}")
        command = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().decode(errors="replace")
        jobs = {path.name.split("_")[1].split(".")[0] for path in sockets.glob(f"{node}_*")}
        return str(self.folder).encode() in environment and any(f"[{job}." in command for job in jobs)

    def run(self, *words, timeout=600):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=timeout)

    def states(self):
        return set(self.run("sinfo", "--noheader", "--Node", "--format=%T").stdout.split())

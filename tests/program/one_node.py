# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of its own for a test: one node, this machine, everything in one folder, on loopback."""

import ctypes
import os
import shutil
import signal
import socket
import subprocess
import time

COMMANDS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol")
# the daemons live in /usr/sbin, which is not in every path
PATH = f"{os.environ['PATH']}:/usr/sbin:/sbin"
N_STARTS = 3
PR_SET_PDEATHSIG = 1

CONFIGURATION = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SlurmdParameters=config_overrides
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class NoSlurm(Exception):
    """Why there is none."""


class OneNode:
    """The daemons; they end with the process that has started them."""

    def __init__(self, folder):
        missing = [name for name in COMMANDS if not shutil.which(name, path=PATH)]
        if missing:
            raise NoSlurm(f"Slurm is not installed: no {', '.join(missing)}")
        if os.geteuid() != 0:
            raise NoSlurm("only root can start Slurm's daemons")
        self.folder = folder
        self.daemons = []
        self.environment = {key: value for key, value in os.environ.items() if not key.startswith(("SLURM_", "SBATCH_"))}
        self.environment.update(PATH=PATH, SLURM_CONF=f"{folder}/slurm.conf")
        for _ in range(N_STARTS):
            # another process may have taken a port that was free before
            if self.start():
                return
            self.stop()
        raise NoSlurm(f"Slurm does not start here\n{self.logs()}")

    def start(self):
        """Start everything; is the node ready for jobs?"""
        for name in ("state", "spool"):
            shutil.rmtree(self.folder / name, ignore_errors=True)
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        if not key.exists():
            key.write_bytes(os.urandom(128))
            key.chmod(0o400)
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(host=host, folder=self.folder, ports=free_ports(2)))
        self.daemon("munged", "--foreground", "--force", *(f"--{option}={self.folder}/munge.{ending}" for option, ending in [
            ("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("log-file", "log"), ("seed-file", "seed")]))
        if not wait(lambda: (self.folder / "munge.socket").exists(), 10, self.are_alive):
            return False
        self.daemon("slurmctld", "-D", "-c", "-f", f"{self.folder}/slurm.conf")
        self.daemon("slurmd", "-D", "-c", "-f", f"{self.folder}/slurm.conf")
        return wait(lambda: "State=IDLE" in self.say("scontrol", "show", "node", host), 30, self.are_alive)

    def daemon(self, name, *options):
        """Start a daemon that does not outlive this process."""
        library = ctypes.CDLL(None)
        with open(self.folder / f"{name}.out", "ab") as output:
            self.daemons.append(subprocess.Popen(
                [name, *options], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, stdout=output,
                stderr=output, start_new_session=True,
                preexec_fn=lambda: library.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)))

    def are_alive(self):
        return all(daemon.poll() is None for daemon in self.daemons)

    def stop(self):
        """Cancel the jobs, then end the daemons, the last one first."""
        if self.daemons and self.are_alive():
            self.say("scancel", "--quiet", "--user=root", timeout=10)
            wait(lambda: not self.say("squeue", "--noheader"), 40, self.are_alive)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons = []

    def say(self, *command, timeout=30):
        """Standard output of a command; empty if it fails."""
        try:
            return subprocess.run(command, env=self.environment, text=True, capture_output=True, timeout=timeout).stdout
        except subprocess.TimeoutExpired:
            return ""

    def state(self, job):
        """State of a job, or of a task as in 12_3: PENDING, RUNNING, COMPLETED, FAILED, CANCELLED ..."""
        fields = self.say("scontrol", "show", "job", str(job)).split()
        states = [field.removeprefix("JobState=") for field in fields if field.startswith("JobState=")]
        return states[0] if states else ""

    def wait_for_end(self, job, seconds):
        """State in which a job has ended."""
        wait(lambda: self.state(job) not in ("PENDING", "RUNNING", "COMPLETING", ""), seconds, self.are_alive)
        return self.state(job)

    def logs(self):
        """The ends of what the daemons have written."""
        text = []
        for path in sorted([*self.folder.glob("*.log"), *self.folder.glob("*.out")]):
            lines = path.read_text(errors="replace").splitlines()[-25:]
            text.append("\n".join([f"--- {path.name}", *lines]))
        return "\n".join(text)


def wait(is_so, seconds, may_go_on=lambda: True):
    """Wait until something is so; is it?"""
    end = time.monotonic() + seconds
    while not is_so():
        if time.monotonic() > end or not may_go_on():
            return False
        time.sleep(0.05)
    return True


def free_ports(n):
    """Ports that nobody uses at this moment; those of the system are all different."""
    sockets = [socket.socket() for _ in range(n)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports

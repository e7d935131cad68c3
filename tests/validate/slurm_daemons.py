"""Starts Slurm on this machine alone: munged, slurmctld and slurmd as processes that end with the test.

Debian: slurmctld slurmd slurm-client munge. All files are in the folder given; ports are free ones of the loopback.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import pwd
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")

# Without cgroups and without a database. A task comes back seconds after its return to the queue, not after two minutes:
# Slurm waits for the life of its credential.
CONFIGURATION = """ClusterName=keyblock
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=1
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
ReturnToService=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SwitchType=switch/none
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def found(name):
    return shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def why_not():
    """Returns the reason why Slurm cannot run here; empty if it can."""
    missing = [name for name in PROGRAMS if not found(name)]
    if missing:
        return f"{', '.join(missing)} not installed (Debian: slurmctld slurmd slurm-client munge)"
    return "" if os.geteuid() == 0 else "slurmd needs root"


def _free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Slurm:
    """A cluster of one node. `with Slurm(folder) as slurm: slurm.submit(script, folder)`."""

    def __init__(self, folder, processors=2):
        self.folder = Path(folder).resolve()
        self.daemons = []
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        controller, daemon = _free_ports(2)
        host = socket.gethostname().split(".")[0]
        text = CONFIGURATION.format(folder=self.folder, host=host, controller=controller, daemon=daemon,
                                    processors=processors, user=pwd.getpwuid(os.geteuid()).pw_name)
        (self.folder / "slurm.conf").write_text(text, encoding="utf-8")
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def __enter__(self):
        try:
            self._start_munge()
            self._start("slurmctld", "-D", "-i")
            self._start("slurmd", "-D")
            self._wait_until(lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"), "the node to be idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.daemons):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def _start(self, name, *options):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons.append(subprocess.Popen([found(name), *options], env=self.environment, stdout=out,
                                                 stderr=out, stdin=subprocess.DEVNULL, start_new_session=True))

    def _start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        paths = {name: self.folder / f"munge.{name}" for name in ("socket", "pid", "log", "seed")}
        # --force: the folder is one of a test, and not one of the system.
        self._start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={paths['socket']}",
                    f"--pid-file={paths['pid']}", f"--log-file={paths['log']}", f"--seed-file={paths['seed']}")
        self._wait_until(paths["socket"].exists, "the socket of munged")

    def _wait_until(self, is_so, what, limit=60):
        end = time.monotonic() + limit
        while not is_so():
            dead = [process.args[0] for process in self.daemons if process.poll() is not None]
            if dead or time.monotonic() > end:
                logs = "\n".join(f"{log.name}: {log.read_text(errors='replace')[-2000:]}" for log in sorted(self.folder.glob("*.log")))
                raise RuntimeError(f"Slurm: expected {what}, found {dead or 'nothing'}\n{logs}")
            time.sleep(0.1)

    def ask(self, program, *arguments, cwd=None, text=None, limit=None):
        """Returns what a command of Slurm prints; its errors count as no answer. `limit`: seconds, then it is ended:
        scancel repeats a request for long if the signal has ended the task."""
        try:
            return subprocess.run([found(program), *arguments], env=self.environment, cwd=cwd, input=text, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=limit).stdout
        except subprocess.TimeoutExpired:
            return ""

    def submit(self, script, folder, *options):
        """Submits a script by standard input, as in `keyblock sweep … --slurm 8 | sbatch`. Returns the number of the job."""
        return self.ask("sbatch", "--parsable", *options, cwd=folder, text=script).strip()

    def tasks(self, job):
        """Returns the states of the tasks of a job that has not ended: dict of numbers in the array and states."""
        lines = self.ask("squeue", "-h", "-r", "-j", job, "-o", "%K %T").split("\n")
        return dict(line.split() for line in lines if line.strip())

    def wait(self, job, limit=3600):
        """Waits until no task of the job is in the queue."""
        self._wait_until(lambda: not self.tasks(job), f"the end of job {job}", limit)

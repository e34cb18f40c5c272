#!/usr/bin/env python3
"""What unit_in_vm.py runs as root inside its virtual machine: the service under a real systemd.

    unit_in_vm_checks.py [NAME[,NAME...]]

The machine has been booted with the packages installed as README.md says and the service enabled.
Prints "ok NAME: words" or "FAILED NAME: words" for each check, PLAY when a player outside may
connect, END at the end. Ends with 0 whatever was found.
"""

import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import ssl
import subprocess
import sys
import time
import traceback
import urllib.request

from independent_peer import Bytes, Client, END, Error, Hello

SERVICE, SOCKET = "au-transmitter.service", "au-transmitter.socket"
PORT = 4650
ETC, STATE = pathlib.Path("/etc/aucast"), pathlib.Path("/var/lib/aucast")
SETTINGS, STREAMS = ETC / "au-transmitter.toml", STATE / "streams"
DROP_INS = pathlib.Path("/run/systemd/system")
INSTALLED = pathlib.Path("/usr")
PACKAGES = pathlib.Path("/opt/packages")
INSTANCES = [f"au-transmitter@{number}.service" for number in (1, 2)]
TALK = INSTALLED / "share/aucast/streams/talk.txt"
PATIENCE = 60  # seconds: an emulated processor is slow
WATCHDOG = 30

CHECKS = []


def check(function):
    CHECKS.append(function)
    return function


def expect(holds, words):
    if not holds:
        raise AssertionError(words)


def run(*command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **more)
    expect(done.returncode == 0, f"{' '.join(map(str, command))}: {done.returncode}, {done.stdout}")
    return done.stdout


def systemctl(*arguments):
    return run("systemctl", *arguments)


def show(*names, unit=SERVICE):
    """Properties of a unit; of one name, its value."""
    said = systemctl("show", "-p", ",".join(names), unit)
    values = dict(line.split("=", 1) for line in said.splitlines())
    return values if len(names) > 1 else values[names[0]]


def wait_for(what, words, seconds=PATIENCE):
    until = time.monotonic() + seconds
    while not (value := what()):
        expect(time.monotonic() < until, f"in {seconds} s never: {words}")
        time.sleep(0.2)
    return value


class Journal:
    """What the service says from now on."""

    def __init__(self):
        run("journalctl", "--sync")
        said = run("journalctl", "-q", "-n", "0", "--show-cursor")
        self.cursor = re.search(r"cursor: (\S+)", said)[1]

    def entries(self, name="SYSLOG_IDENTIFIER", value="au-transmitter"):
        run("journalctl", "--sync")
        # Not chosen by journalctl: after a cursor that it would not have chosen it leaves one out.
        said = run("journalctl", "-q", "-o", "json", "--after-cursor", self.cursor)
        return [entry for entry in map(json.loads, said.splitlines()) if entry.get(name) == value]

    def has(self, pattern):
        """The first entry that has it."""
        found = (entry for entry in self.entries() if re.search(pattern, entry["MESSAGE"]))
        return next(found, None)

    def wait_for(self, pattern):
        try:
            return wait_for(lambda: self.has(pattern), f"{pattern!r} in the journal")
        except AssertionError as error:
            said = [entry["MESSAGE"] for entry in self.entries("UNIT", SERVICE) + self.entries()]
            raise AssertionError(f"{error}; there is {said}") from error


def settings(text="", **values):
    """The settings that were installed with other values, and `text` after them."""
    lines = (INSTALLED / "share/doc/aucast/au-transmitter.toml").read_text(encoding="ascii")
    for name, value in values.items():
        name = name.replace("_", "-")
        lines = re.sub(rf"(?m)^{name} = .*\n", "", lines) + f"{name} = {json.dumps(value)}\n"
    SETTINGS.write_text(lines + text, encoding="ascii")


def drop_in(text, unit=SERVICE):
    folder = DROP_INS / f"{unit}.d"
    folder.mkdir(parents=True)
    (folder / "check.conf").write_text(text, encoding="ascii")
    systemctl("daemon-reload")


def as_booted():
    """Whatever the check before has left, the service serves happiness, once more unrestarted."""
    for unit in (SERVICE, SOCKET):
        shutil.rmtree(DROP_INS / f"{unit}.d", ignore_errors=True)
    systemctl("daemon-reload")
    systemctl("stop", SOCKET, SERVICE, *INSTANCES)
    systemctl("reset-failed")
    for path in STREAMS.iterdir():
        if path.name != "happiness.txt":
            path.unlink()
    settings()
    systemctl("start", SERVICE)


def stream(name, keyframes):
    (STREAMS / f"{name}.txt").write_text(f"Beg_Stream\n{keyframes}End_Stream\n", encoding="ascii")


def played(hello=None, client=None):
    """The keyframes that a client gets, answering each."""
    with client or Client(PORT, hello) as peer:
        if hello:
            granted = peer.packet(PATIENCE)
            expect(isinstance(granted, Hello), f"{granted} to {hello}")
        return [keyframe.text for keyframe in peer.rest(seconds=PATIENCE)]


class TlsClient(Client):
    def __init__(self, hello, authority):
        context = ssl.create_default_context(cafile=authority)
        plain = socket.create_connection(("127.0.0.1", PORT), PATIENCE)
        Bytes.__init__(self, context.wrap_socket(plain, server_hostname="localhost"))
        self.send(hello)


def make_secrets(token, mode, group="root"):
    """A key, a certificate for localhost by itself, and a token."""
    run("openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes",
        "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost", "-days", "2",
        "-keyout", ETC / "key.pem", "-out", ETC / "cert.pem")
    (ETC / "token").write_text(token + "\n", encoding="ascii")
    for name in ("token", "key.pem"):
        shutil.chown(ETC / name, group=group)
        (ETC / name).chmod(mode)


def main_process():
    return pathlib.Path("/proc") / show("MainPID")


def restart():
    systemctl("restart", SERVICE)


# ------------------------------------------------------------------------------------------------


@check
def boot():
    """Enabled, it is there after a boot."""
    wait_for(lambda: show("ActiveState") == "active", "the service is active", 120)
    told = show("Type", "WatchdogUSec", "DynamicUser", "StatusText", "NRestarts", "FragmentPath")
    expect(told["Type"] == "notify" and told["WatchdogUSec"] == f"{WATCHDOG}s", told)
    expect(told["DynamicUser"] == "yes" and told["NRestarts"] == "0", told)
    expect(told["StatusText"] == "0 clients, 1 stream", told)
    return f"{told}"


@check
def verify():
    """systemd has nothing to complain of, and what the unit names is there."""
    said = run("systemd-analyze", "verify", "--man=no", SERVICE, SOCKET, *INSTANCES)
    expect(said == "", said)
    program = re.search(r"path=(\S+)", show("ExecStart"))[1]
    expect(program == str(INSTALLED / "bin/au-transmitter"), program)
    name = "au-transmitter"
    places = [f"share/{place}" for place in
              (f"man/man1/{name}.1.gz", f"bash-completion/completions/{name}",
               f"zsh/site-functions/_{name}", f"fish/vendor_completions.d/{name}.fish")]
    missing = [place for place in places if not (INSTALLED / place).is_file()]
    expect(not missing, f"not installed: {missing}")
    security = run("systemd-analyze", "security", "--no-pager", "--threshold=20", SERVICE)
    return re.search(r"Overall exposure.*: ([0-9.]+ \w+)", security)[0]


@check
def client():
    """Both levels play what was copied to the folder of streams."""
    expect(played() == ["{1,6,12,14}"], played())
    expect(played("{hello v=2 window=2}") == ["{1,6,12,14}"],
           played("{hello v=2 window=2}"))
    return "classic and level 2"


@check
def status_text():
    """systemctl status tells how many clients there are."""
    with Client(PORT, "{hello v=2}") as peer:
        peer.packet(PATIENCE)
        wait_for(lambda: show("StatusText") == "1 client, 1 stream", "the status has the client")
    return re.search(r"Status: .*", systemctl("status", "--no-pager", SERVICE))[0]


@check
def journal():
    """Priorities are the journal's, and no entry begins with one."""
    since = Journal()
    with Client(PORT, "nonsense"):
        warning = since.wait_for("client .* closed")
    systemctl("kill", "-s", "SIGUSR1", SERVICE)
    info = since.wait_for("status: up .*; clients 0")
    expect((warning["PRIORITY"], info["PRIORITY"]) == ("4", "6"), f"{warning} {info}")
    for entry in since.entries():
        expect(not entry["MESSAGE"].startswith("<"), entry)
        expect(entry["_SYSTEMD_UNIT"] == SERVICE, entry)
    return f"4: {warning['MESSAGE']}; 6: {info['MESSAGE']}"


@check
def http():
    """A monitor on this host finds it healthy."""
    with urllib.request.urlopen("http://127.0.0.1:9465/healthz", timeout=PATIENCE) as answer:
        expect(answer.status == 200, answer.status)
    metrics = run("curl", "-sf", "http://127.0.0.1:9465/metrics")
    expect(re.search(r"(?m)^aucast_clients 0(\.0)?$", metrics), metrics)
    told = json.loads(run("curl", "-sf", "http://127.0.0.1:9465/status.json"))
    return f"streams {told['streams']}"


@check
def sandbox():
    """What the program could do there, tried by a shell in its place."""
    probe = ("for f in / /etc /usr/bin /root /home /srv /var /run /proc/sys/kernel; do "
             "(: >$f/probe) 2>&- && echo could write to $f; done; "
             "(: >/var/lib/aucast/probe) && echo has its folder; "
             "cat /etc/shadow >&- 2>&- && echo could read secrets; "
             "ls /dev/vda 2>&- && echo could see the disk; "
             "test -e /proc/1/status && echo could see others; "
             "unshare -r true 2>&- && echo could make a namespace; "
             "id -u; sed -n 's/^\\(NoNewPrivs\\|Seccomp\\|CapBnd\\):\\s*/\\1=/p' /proc/self/status")
    since = Journal()
    systemctl("stop", SERVICE)
    drop_in("[Service]\nType=oneshot\nWatchdogSec=0\nRestart=no\nExecReload=\nExecStart=\n"
            "SyslogIdentifier=au-transmitter\nExecStart=/bin/sh -c \"" +
            probe.replace("$", "$$").replace("\\", "\\\\").replace('"', '\\"') + "\"\n")
    systemctl("start", SERVICE)
    said = [entry["MESSAGE"] for entry in since.entries()]
    expect(not [line for line in said if line.startswith("could")], said)
    expect("has its folder" in said and "Seccomp=2" in said and "NoNewPrivs=1" in said, said)
    expect("CapBnd=0000000000000000" in said and "0" not in said, said)
    (STATE / "probe").unlink()
    return ", ".join(said)


@check
def nats():
    """The module for NATS is loaded in there too."""
    settings(publish="nats://127.0.0.1:1/talk")
    since = Journal()
    restart()
    told = since.wait_for("no server of NATS answers yet")
    mapped = (main_process() / "maps").read_text(encoding="ascii")
    expect("/usr/lib/aucast/aucast-nats.so" in mapped, mapped)
    return told["MESSAGE"]


@check
def reload():
    """A reload takes new streams, and who plays plays on."""
    pid, since = show("MainPID"), Journal()
    with Client(PORT, "{hello v=2 stream=happiness}") as peer:
        peer.packets(2)
        stream("second", "2\n5\n")
        systemctl("reload", SERVICE)
        since.wait_for("serving 2 streams now")
        expect(played("{hello v=2 stream=second}") == ["{2}", "{5}"], "not served")
        peer.send("1")
        expect(peer.packet(PATIENCE) == END, "who was there is disturbed")
    wait_for(lambda: show("SubState") == "running", "the reload is over")
    expect(show("MainPID") == pid, "another process")
    (STREAMS / "broken.txt").write_text("Beg_Stream\nnonsense\n", encoding="ascii")
    systemctl("reload", SERVICE)
    told = since.wait_for("what was served before is served on")
    expect(told["PRIORITY"] == "3", told)
    wait_for(lambda: show("SubState") == "running", "the broken reload is over")
    expect(played() == ["{1,6,12,14}"], "not served on")
    return "streams taken over; broken ones said with priority 3 and not taken over"


@check
def secrets():
    """Key and token of root alone, through LoadCredential=, as the unit's comment says."""
    make_secrets("open-sesame", 0o600)
    given = "/run/credentials/au-transmitter.service"
    settings(tls_cert=str(ETC / "cert.pem"), tls_key=f"{given}/key.pem",
             token_file=f"{given}/token")
    drop_in("[Service]\nLoadCredential=key.pem:/etc/aucast/key.pem\n"
            "LoadCredential=token:/etc/aucast/token\n")
    since = Journal()
    restart()
    hello = "{hello v=2 token=open-sesame}"
    got = played(hello, TlsClient(hello, ETC / "cert.pem"))
    expect(got == ["{1,6,12,14}"], got)
    with TlsClient("{hello v=2 token=sesame}", ETC / "cert.pem") as peer:
        refused = peer.packet(PATIENCE)
        expect(isinstance(refused, Error) and refused.code == 401, refused)
    said = [entry["MESSAGE"] for entry in since.entries()]
    expect(not since.has("sesame"), f"the token is in the journal: {said}")
    expect(not since.has("other users have access"), said)
    return "TLS, 401 without the token"


@check
def rotation():
    """Key, certificate and token that a group may read are taken anew by a reload."""
    run("groupadd", "--system", "--force", "aucast")
    make_secrets("open-sesame", 0o640, "aucast")
    settings(tls_cert=str(ETC / "cert.pem"), tls_key=str(ETC / "key.pem"),
             token_file=str(ETC / "token"))
    drop_in("[Service]\nSupplementaryGroups=aucast\n")
    since = Journal()
    restart()
    first = (ETC / "cert.pem").read_text(encoding="ascii")
    with TlsClient("{hello v=2 token=open-sesame}", ETC / "cert.pem") as peer:
        peer.packets(2)
        make_secrets("open-barley", 0o640, "aucast")
        systemctl("reload", SERVICE)
        since.wait_for("certificates and token were read again")
        hello = "{hello v=2 token=open-barley}"
        got = played(hello, TlsClient(hello, ETC / "cert.pem"))
        expect(got == ["{1,6,12,14}"], got)
        with TlsClient("{hello v=2 token=open-sesame}", ETC / "cert.pem") as late:
            refused = late.packet(PATIENCE)
            expect(isinstance(refused, Error) and refused.code == 401, refused)
        peer.send("1")
        expect(peer.packet(PATIENCE) == END, "who was there is disturbed")
    expect((ETC / "cert.pem").read_text(encoding="ascii") != first, "the same certificate")
    said = [entry["MESSAGE"] for entry in since.entries()]
    expect(not since.has("other users have access"), said)
    return "new certificate and token, the old token gets 401, who was there plays on"


@check
def named_address():
    """Names are looked up inside the sandbox too."""
    settings(bind="localhost")
    restart()
    expect(played() == ["{1,6,12,14}"], "not served")
    return "bind = localhost"


@check
def watchdog():
    """A process that hangs is ended and started again; who came meanwhile has waited."""
    systemctl("stop", SERVICE)
    systemctl("start", SOCKET, SERVICE)
    process, since = main_process(), time.monotonic()
    os.kill(int(process.name), signal.SIGSTOP)
    waiting = [Client(PORT, "{hello v=2}") for _ in range(20)]
    wait_for(lambda: show("NRestarts") == "1" and show("ActiveState") == "active",
             "it was started again", WATCHDOG + PATIENCE)
    seconds = time.monotonic() - since
    expect(main_process() != process, "the same process")
    said = run("journalctl", "-b", "-o", "cat", "_PID=1", f"UNIT={SERVICE}")
    expect("Watchdog timeout" in said, said)
    for peer in waiting:
        expect(isinstance(peer.packet(PATIENCE), Hello), "who waited was lost")
        peer.socket.close()
    return f"SIGSTOP, serving 20 who came meanwhile after {seconds:.0f} s"


@check
def crash():
    """A killed process is started again."""
    systemctl("kill", "-s", "SIGKILL", SERVICE)
    wait_for(lambda: show("NRestarts") == "1" and show("ActiveState") == "active",
             "it was started again")
    expect(played() == ["{1,6,12,14}"], "not served")
    return "SIGKILL, serving again"


@check
def stop():
    """Clients hear the end, the exit code is 0, and the statistics are where they may be."""
    settings(stats="stats.json")
    restart()
    with Client(PORT, "{hello v=2}") as peer:
        peer.packets(2)
        systemctl("stop", SERVICE)
        expect(peer.packet(PATIENCE) == END, "no {-2}")
        peer.expect_end()
    told = show("Result", "ExecMainStatus", "ActiveState")
    expect(told == {"Result": "success", "ExecMainStatus": "0", "ActiveState": "inactive"}, told)
    stats = json.loads((STATE / "stats.json").read_text(encoding="utf-8"))
    return f"{told}, statistics of {len(stats['clients'])} clients"


def failing(code, words, text="", **values):
    """The start fails with this code, which is said, and is not tried again."""
    settings(text, **values)
    systemctl("reset-failed", SERVICE)
    since = Journal()
    started = subprocess.run(("systemctl", "restart", SERVICE), stderr=subprocess.DEVNULL,
                             check=False)
    expect(started.returncode != 0, "it starts")
    said = since.wait_for(words)
    expect(said["PRIORITY"] == "3", said)
    time.sleep(4)  # RestartSec=3 and some
    told = show("ExecMainStatus", "NRestarts", "ActiveState", "Result")
    expect(told == {"ExecMainStatus": str(code), "NRestarts": "0", "ActiveState": "failed",
                    "Result": "exit-code"}, told)
    status = subprocess.run(("systemctl", "status", "--no-pager", SERVICE), text=True, check=False,
                            stdout=subprocess.PIPE).stdout
    expect(f"status={code}" in status, status)
    return f"{code}: {said['MESSAGE']}"


@check
def failures():
    """What an operator got wrong ends with its exit code, is said, and is not tried again."""
    (STREAMS / "broken.txt").write_text("Beg_Stream\nnonsense\nEnd_Stream\n", encoding="ascii")
    said = [failing(3, "broken.txt:2:1")]
    (STREAMS / "broken.txt").unlink()
    said += [failing(3, "no-such-option", "no-such-option = 1\n"),
             failing(2, "--save-profile", save_profile="p", neutral="2"),
             failing(4, "nowhere.txt", source=["/srv/nowhere.txt"]),
             failing(4, "shadow", token_file="/etc/shadow")]
    return "; ".join(said)


@check
def port_taken():
    """A port that is taken is tried again every third second until it is free."""
    systemctl("stop", SERVICE)
    with socket.create_server(("0.0.0.0", PORT)):
        subprocess.run(("systemctl", "start", SERVICE), stderr=subprocess.DEVNULL, check=False)
        time.sleep(20)
        told = show("ExecMainStatus", "NRestarts", "ActiveState")
        expect(told["ExecMainStatus"] == "5" and told["ActiveState"] == "activating", told)
        expect(2 <= int(told["NRestarts"]) <= 8, told)
    wait_for(lambda: show("ActiveState") == "active", "it has the port")
    expect(played() == ["{1,6,12,14}"], "not served")
    return f"{told['NRestarts']} restarts in 20 s, then served"


@check
def activation():
    """systemd listens, the first client starts the service, and nobody is lost."""
    systemctl("stop", SERVICE)
    systemctl("start", SOCKET)
    expect(show("ActiveState") == "inactive", "the socket alone starts it")
    since = Journal()
    peers = [Client(PORT, "{hello v=2}") for _ in range(100)]
    for peer in peers:
        expect(isinstance(peer.packet(PATIENCE), Hello), "no hello")
        got = [keyframe.text for keyframe in peer.rest(seconds=PATIENCE)]
        expect(got == ["{1,6,12,14}"], got)
        peer.socket.close()
    since.wait_for(r"client 1 127\.0\.0\.1:\d+: connected")
    with socket.create_connection(("::1", PORT), PATIENCE):
        since.wait_for(r"client 101 \[::1\]:\d+: connected")
    first = show("MainPID")
    with Client(PORT, "{hello v=2}") as peer:
        peer.packets(2)
        with contextlib.ExitStack() as waiting:
            restarted = subprocess.Popen(("systemctl", "restart", SERVICE))
            others = [waiting.enter_context(Client(PORT, "{hello v=2}")) for _ in range(20)]
            expect(peer.packet(PATIENCE) == END, "no {-2}")
            for other in others:
                expect(isinstance(other.packet(PATIENCE), Hello), "lost during the restart")
            expect(restarted.wait() == 0, "no restart")
    expect(show("MainPID") != first, "the same process")
    systemctl("stop", SERVICE)
    expect(played() == ["{1,6,12,14}"], "does not start again")
    return "100 clients at once, one by IPv6, 20 during a restart, one after a stop"


@check
def low_port():
    """A port below 1024 comes from the socket unit: the service has no right to one."""
    systemctl("stop", SERVICE)
    drop_in("[Socket]\nListenStream=\nListenStream=443\n", SOCKET)
    systemctl("start", SOCKET)
    with socket.create_connection(("127.0.0.1", 443), PATIENCE) as peer:
        peer.sendall(b"1")
        got = b""
        while part := peer.recv(4096):
            got += part
    expect(got == b"{1,6,12,14}{-2}", got)
    return "443"


@check
def activated_failure():
    """A service that cannot start does not make its socket spin."""
    systemctl("stop", SERVICE)
    settings("no-such-option = 1\n")
    since = Journal()
    systemctl("start", SOCKET)
    with socket.create_connection(("127.0.0.1", PORT), PATIENCE):
        time.sleep(20)
    starts = len([entry for entry in since.entries("UNIT", SERVICE)
                  if "Starting" in entry["MESSAGE"]])
    told = show("ActiveState", "Result", "SubState", unit=SOCKET)
    expect(1 <= starts <= 10, f"{starts} starts in 20 s")
    return f"{starts} starts, then the socket is {told}"


@check
def no_settings():
    """Without a settings file nothing starts, and the socket does not spin."""
    systemctl("stop", SERVICE)
    SETTINGS.unlink()
    systemctl("start", SERVICE)
    told = show("ConditionResult", "ActiveState")
    expect(told == {"ConditionResult": "no", "ActiveState": "inactive"}, told)
    since = Journal()
    systemctl("start", SOCKET)
    told = show("ConditionResult", "ActiveState", unit=SOCKET)
    expect(told == {"ConditionResult": "no", "ActiveState": "inactive"}, told)
    return "neither service nor socket"


@check
def follow():
    """A recogniser's table in its folder is followed as it grows."""
    table = STATE / "camera.csv"
    table.write_text("frame, face_id, timestamp, confidence, success, AU12_r\n", encoding="ascii")
    settings(source=[str(table)], follow=True)
    restart()
    with Client(PORT, "{hello v=2 window=0}") as peer:
        expect(isinstance(peer.packet(PATIENCE), Hello), "no hello")
        with open(table, "a", encoding="ascii") as file:
            file.write("1, 0, 0.033, 0.98, 1, 5.00\n")
        got = peer.packet(PATIENCE)
    expect(got.terms == [("", 12, 100)], got)
    table.unlink()
    return got.text


@check
def recording():
    """A FIFO in its folder is served as it is written, and recorded beside it."""
    fifo = STATE / "camera"
    os.mkfifo(fifo)
    fifo.chmod(0o644)
    settings(source=[str(fifo)], record=str(STATE / "kept.txt"))
    restart()
    with open(fifo, "w", encoding="ascii") as camera:
        camera.write("Beg_Stream\n1\n")
        camera.flush()
        with Client(PORT, "{hello v=2 window=0}") as peer:
            expect(isinstance(peer.packet(PATIENCE), Hello), "no hello")
            expect(peer.packet(PATIENCE).terms == [("", 1, 100)], "not the first keyframe")
            camera.write("2\nEnd_Stream\n")
            camera.flush()
            expect(peer.packet(PATIENCE).terms == [("", 2, 100)], "not the next keyframe")
    systemctl("stop", SERVICE)
    kept = (STATE / "kept.txt").read_text(encoding="ascii")
    expect(re.fullmatch(r"(#.*\n)*Beg_Stream\n1(;\d+)?\n(1;\d+\n)?2(;\d+)?\n(2;\d+\n)?End_Stream\n",
                        kept), kept)
    fifo.unlink()
    return " ".join(kept.split())


def active(unit):
    return show("ActiveState", unit=unit) == "active"


def clients_of(number):
    """How many clients an instance has, by its own status."""
    metrics = run("curl", "-sf", f"http://127.0.0.1:946{number}/metrics")
    return int(float(re.search(r"(?m)^aucast_clients (\S+)$", metrics)[1]))


@check
def instances():
    """Two instances share the port; one is restarted, and its clients come again to the other."""
    systemctl("stop", SERVICE)
    settings(drain_time=3, loop=True)
    systemctl("start", *INSTANCES)
    with contextlib.ExitStack() as playing:
        peers = [playing.enter_context(Client(PORT, "{hello v=2}")) for _ in range(40)]
        for peer in peers:
            peer.packets(2)
        spread = [clients_of(number) for number in (1, 2)]
        expect(min(spread) > 0 and sum(spread) == 40, spread)
        first = show("MainPID", unit=INSTANCES[0])
        systemctl("restart", INSTANCES[0])
        expect(show("MainPID", unit=INSTANCES[0]) != first, "the same process")
        gone = [peer for peer in peers if not peer.is_quiet()]
        for peer in gone:
            expect(peer.packet(PATIENCE) is None, "a client was told that the stream ends")
        cut_off = len(gone)
        expect(cut_off == spread[0], f"{cut_off} were cut off, and it had {spread[0]}")
    told = show("Result", "NRestarts", unit=INSTANCES[0])
    expect(told == {"Result": "success", "NRestarts": "0"}, told)
    return f"{spread} clients, {cut_off} cut off by the restart, none ended"


def install():
    return run("dpkg", "-i", *map(str, sorted(PACKAGES.glob("*.deb"))))


@check
def upgrade():
    """What runs takes the new program, what does not run is not started."""
    first = show("MainPID")
    install()
    wait_for(lambda: active(SERVICE) and show("MainPID") != first, "it was restarted")
    expect(played() == ["{1,6,12,14}"], "not served")
    expect(not any(map(active, (SOCKET, *INSTANCES))), "what did not run was started")
    systemctl("stop", SERVICE)
    systemctl("start", *INSTANCES)
    before = [show("MainPID", unit=unit) for unit in INSTANCES]
    install()
    after = [show("MainPID", unit=unit) for unit in INSTANCES]
    expect(all(map(active, INSTANCES)) and not set(before) & set(after), f"{before} {after}")
    expect(not active(SERVICE), "what did not run was started")
    return "the service, then two instances"


@check
def player():
    """A player on another host."""
    shutil.copy(TALK, STREAMS / "a_talk.txt")
    restart()
    since = Journal()
    print("PLAY", flush=True)
    return since.wait_for("client .* closed|client .* finished")["MESSAGE"]


def main():
    wanted = [name for name in sys.argv[1].split(",") if name] if len(sys.argv) > 1 else []
    for function in CHECKS:
        if wanted and function.__name__ not in wanted:
            continue
        try:
            if function is not boot:
                as_booted()
            print(f"ok     {function.__name__}: {function()}", flush=True)
        except AssertionError as error:
            print(f"FAILED {function.__name__}: {' / '.join(str(error).splitlines())}", flush=True)
        except Exception:
            words = " / ".join(traceback.format_exc().splitlines())
            print(f"FAILED {function.__name__}: {words}", flush=True)
    print("END", flush=True)


if __name__ == "__main__":
    main()

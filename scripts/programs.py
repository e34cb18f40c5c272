"""au-transmitter as a child process, for scripts and for tests in Python."""

import pathlib
import subprocess


class Transmitter:
    """au-transmitter of a folder of programs, from its ready line to stop() or the end of a `with`.

    It has no settings but its arguments, and a free port. `before` stands before its name on the
    command line; what else is named goes to subprocess."""

    def __init__(self, binaries, *arguments, before=(), stderr=subprocess.DEVNULL, **more):
        if "--port" not in arguments:
            arguments = ("--port", "0", *arguments)
        self.process = subprocess.Popen(
            [*before, pathlib.Path(binaries) / "au-transmitter", "--config", "/dev/null",
             *map(str, arguments)], stdout=subprocess.PIPE, stderr=stderr, text=True, **more)
        line = self.process.stdout.readline()
        if not line.startswith("listening on "):
            said = self.process.communicate()[1]
            raise OSError(f"au-transmitter did not start: {line}{said or ''}")
        self.address = line.split()[-1]
        self.port = int(self.address.rsplit(":", 1)[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """Its exit code, after SIGTERM if it has not ended."""
        if self.process.poll() is None:
            self.process.terminate()
        code = self.process.wait(20)
        self.process.stdout.close()
        return code

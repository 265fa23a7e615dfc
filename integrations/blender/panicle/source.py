"""Sources of plants: a running Panicle service, or the command line in a copy of the repository."""

import json
import os
import shutil
import subprocess
import urllib.error
import urllib.parse
import urllib.request

# Seconds until a request or a command is given up.
TIMEOUT = 120


class SourceError(Exception):
    """A plant could not be fetched; the message is for the user."""


class Service:
    """A running service (`npm run service`) at an address such as http://127.0.0.1:8765."""

    def __init__(self, address):
        self.address = address.strip().rstrip("/")
        if not self.address.startswith(("http://", "https://")):
            raise SourceError(f"“{address}” is not the address of a service. Enter one such as http://127.0.0.1:8765.")

    def catalogue(self):
        """Returns all models with their presets and parameters."""
        return json.loads(self._fetch("specimens/"))

    def write(self, path, model, preset, seed, parameters, ending, options=None):
        """Writes the file of a plant. `ending` is that of the service, such as `low.glb` or `game.zip`."""
        query = {"seed": seed, **parameters, **{f"file-{key}": value for key, value in (options or {}).items()}}
        address = f"specimens/{model}/{urllib.parse.quote(preset)}.{ending}?{urllib.parse.urlencode(query)}"
        data = self._fetch(address)
        with open(path, "wb") as file:
            file.write(data)

    def _fetch(self, address):
        try:
            with urllib.request.urlopen(f"{self.address}/{address}", timeout=TIMEOUT) as response:
                return response.read()
        except urllib.error.HTTPError as error:
            raise SourceError(_message(error.read()) or f"The service returned status {error.code}.") from error
        except (urllib.error.URLError, OSError) as error:
            reason = getattr(error, "reason", error)
            raise SourceError(
                f"No service at {self.address} ({reason}). Start it with “npm run service”, or correct the address."
            ) from error


class CommandLine:
    """The command line of Panicle, in a copy of the repository after `npm ci`."""

    def __init__(self, folder):
        self.folder = os.path.expanduser(folder)
        self.script = os.path.join(self.folder, "wasm-core", "tools", "grow.mjs")
        if not os.path.isfile(self.script):
            raise SourceError(f"“{folder}” is not a copy of Panicle. Choose the folder that contains package.json.")
        self.node = shutil.which("node")
        if not self.node:
            raise SourceError("Node.js was not found. Install it from nodejs.org, or use a service.")

    def catalogue(self):
        """Returns all models with their presets and parameters."""
        return json.loads(self._run("--list"))

    def write(self, path, model, preset, seed, parameters, ending, options=None):
        """Writes the file of a plant. `ending` is that of the service, such as `low.glb` or `game.zip`."""
        words = [f"{model}/{preset}", "--seed", str(seed), "--out", path]
        for key, value in parameters.items():
            words += ["--set", f"{key}={value}"]
        if "." in ending:
            words += ["--form", ending.split(".")[0]]
        for key, value in (options or {}).items():
            words += [f"--{key}", str(value)]
        self._run(*words)

    def _run(self, *words):
        try:
            command = [self.node, self.script, *words]
            done = subprocess.run(command, cwd=self.folder, capture_output=True, timeout=TIMEOUT, check=False)
        except subprocess.TimeoutExpired as error:
            raise SourceError(f"The plant took longer than {TIMEOUT} s. Choose a smaller plant.") from error
        # Status 6 is a plant that reached a limit: its file is written.
        if done.returncode not in (0, 6):
            lines = done.stderr.decode(errors="replace").strip().splitlines()
            raise SourceError(lines[0] if lines else f"The command ended with status {done.returncode}.")
        return done.stdout.decode()


def _message(body):
    """Returns the message in an error response of the service, if there is one."""
    try:
        return json.loads(body).get("message")
    except (ValueError, AttributeError):
        return None

#!/usr/bin/env python3
"""What starts render nodes is well formed and asks for what it should: the Slurm script, the systemd unit and the
Kubernetes files of installer/. node_files.py SOURCE. Ends with 77 where python3-yaml is missing, having looked at the rest."""

import configparser
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

AGAIN = {69, 70, 75, 134, 137, 139}  # another try may do
NEVER = {64, 76, 77, 78}  # it would end the same way
OPTIONS = {"--coordinator", "--listen", "--bundle", "--name", "--device", "--threads", "--idle-minutes", "--drain-seconds"}


def known_options(words):
    for word in words:
        if word.startswith("--"):
            assert word in OPTIONS, f"pdrender-node has no option {word}"


def slurm(script):
    text = script.read_text()
    subprocess.run(["bash", "-n", script], check=True)
    assert not re.search(r"^\s*exec\b", text, re.M), "a program that takes the shell's place is not run again when killed"
    codes = re.search(r"^\s*([\d |]+)\)$", text, re.M)
    assert codes and {int(code) for code in codes[1].split("|")} == AGAIN, "codes that ask for another try"
    assert "MOST_RESTARTS=20" in text and "REFUSED=78" in text
    assert "#SBATCH --requeue" in text and "#SBATCH --signal=B:USR1@" in text
    known_options(re.search(r"pdrender-node}\" (.*) &$", text, re.M)[1].replace('"', "").split())


def unit_of(service):
    parser = configparser.RawConfigParser(strict=False, interpolation=None)
    parser.optionxform = str
    parser.read(service)
    return parser["Service"]


def systemd(service):
    unit = unit_of(service)
    assert unit["Restart"] == "on-failure" and {int(code) for code in unit["RestartPreventExitStatus"].split()} == NEVER
    for name, value in {"DynamicUser": "yes", "NoNewPrivileges": "yes", "ProtectSystem": "strict", "ProtectHome": "yes",
                        "LimitCORE": "0", "MemorySwapMax": "0", "CapabilityBoundingSet": ""}.items():
        assert unit[name] == value, name
    known_options(unit["ExecStart"].split())
    assert service.read_text().count("LoadCredential=") == 3
    if shutil.which("systemd-analyze"):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / service.name  # it must find the program
            copy.write_text(service.read_text().replace("/usr/bin/pdrender-node", shutil.which("true")))
            done = subprocess.run(["systemd-analyze", "verify", copy], capture_output=True, text=True, timeout=300)
            said = [line for line in done.stderr.splitlines() if service.name in line]
            assert done.returncode == 0 and not said, done.stderr


def pod(spec):
    (node,) = spec["containers"]
    assert node["name"] == "node" and node["command"] == ["pdrender-node"]
    known_options(node["args"])
    assert "PDR_COORDINATOR" in {variable["name"] for variable in node["env"]}
    assert spec["securityContext"]["runAsNonRoot"] and not spec["automountServiceAccountToken"]
    assert node["securityContext"]["readOnlyRootFilesystem"] and not node["securityContext"]["allowPrivilegeEscalation"]
    drain = int(node["args"][node["args"].index("--drain-seconds") + 1])
    assert drain < spec["terminationGracePeriodSeconds"], "it is killed while it drains"


def shares(folder, yaml):
    share, merge = yaml.safe_load_all((folder / "shares.yaml").read_text())
    for job in (share, merge):
        assert job["kind"] == "Job" and job["apiVersion"] == "batch/v1"
        spec = job["spec"]["template"]["spec"]
        assert spec["restartPolicy"] == "Never" and spec["securityContext"]["runAsNonRoot"]
        (container,) = spec["containers"]
        assert container["securityContext"]["readOnlyRootFilesystem"] and not spec["automountServiceAccountToken"]
    assert share["spec"]["completionMode"] == "Indexed"
    (words,) = share["spec"]["template"]["spec"]["containers"][0]["args"]
    assert f"--share $((JOB_COMPLETION_INDEX + 1))/{share['spec']['completions']} " in words
    (fails,) = [rule["onExitCodes"] for rule in share["spec"]["podFailurePolicy"]["rules"] if rule["action"] == "FailJob"]
    assert fails["containerName"] == "share" and fails["values"] == [2]
    assert merge["spec"]["suspend"] and "pdrender-cli merge" in merge["spec"]["template"]["spec"]["containers"][0]["args"][0]


def kubernetes(folder, yaml):
    shares(folder, yaml)
    deployment = yaml.safe_load((folder / "nodes.yaml").read_text())
    assert deployment["kind"] == "Deployment" and deployment["apiVersion"] == "apps/v1"
    assert deployment["spec"]["selector"]["matchLabels"] == deployment["spec"]["template"]["metadata"]["labels"]
    pod(deployment["spec"]["template"]["spec"])
    job = yaml.safe_load((folder / "render.yaml").read_text())
    assert job["kind"] == "Job" and job["apiVersion"] == "batch/v1" and job["spec"]["completionMode"] == "Indexed"
    rules = job["spec"]["podFailurePolicy"]["rules"]
    (fails,) = [rule["onExitCodes"] for rule in rules if rule["action"] == "FailJob"]
    assert fails["operator"] == "In" and fails["values"] == sorted(NEVER) and fails["containerName"] == "node"
    assert job["spec"]["template"]["spec"]["restartPolicy"] == "Never", "a podFailurePolicy asks for it"
    pod(job["spec"]["template"]["spec"])
    for file in folder.iterdir():
        assert "not run by our tests" in file.read_text().lower(), file


def main():
    installer = Path(sys.argv[1]) / "installer"
    slurm(installer / "slurm/pdrender-node.sbatch")
    systemd(installer / "systemd/pdrender-node.service")
    try:
        import yaml
    except ImportError:
        print("python3-yaml is missing: the Kubernetes files were not looked at")
        return 77
    kubernetes(installer / "kubernetes", yaml)
    return 0


sys.exit(main())

import json
import subprocess
import sys
import time

way = sys.argv[1]
if way == "late":
    time.sleep(60)
if way == "dead":
    sys.exit("cannot import the engine")
if way == "quiet":
    time.sleep(1.2)
if way == "banner":
    print("Engine 3.0\n{}", flush=True)
with open("started", "a") as file:
    file.write("x")
version = open("version").read() if way == "version" else "1"
laws = [] if way == "lawless" else ["impact-spring"]
print(json.dumps({"format": 1, "program": "fake", "version": version, "laws": laws}), flush=True)
for line in sys.stdin:
    request = json.loads(line)
    case, count = request["case"], request["steps"] + 1
    channels = {name: [0.0] * count for name in request["channels"]}
    answer = {"case": case, "channels": channels}
    if way == "asked":
        answer["error"] = "asked for " + " ".join(channels)
    if way == "error":
        answer["error"] = "did not converge at t = 3.21"
    if way == "short":
        answer["channels"] = {name: [0.0] for name in channels}
    if way == "missing":
        answer["channels"] = {}
    if way == "nan":
        answer["channels"] = {name: [float("nan")] * count for name in channels}
    if way == "null":
        answer["channels"] = {name: [None] * count for name in channels}
    if way == "huge":
        answer["channels"] = {name: [1e9] * count for name in channels}
    if way == "gain":
        answer["channels"] = {name: [float(i) for i in range(count)] for name in channels}
    if way == "slow" and case == 1:
        time.sleep(60)
    if way == "stuck":
        time.sleep(60)
    if way == "ends":
        print("abort: matrix is singular", flush=True)
        sys.exit(7)
    if way == "orphan" and case == 1:
        subprocess.Popen([sys.executable, "-c", "import time; time.sleep(20)"])
        sys.exit(7)
    if way == "ends once" and case == 1:
        sys.exit(7)
    if way == "banner":
        print("step 1\n{]\n" + json.dumps({"case": case + 1, "channels": {}}), flush=True)
    if way == "broken":
        print('{"case": %d, "channels": {"a": [1,,2]}}' % case, flush=True)
        continue
    print(json.dumps(answer), flush=True)

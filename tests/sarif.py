"""Holds a log of `scn lint --format sarif` to the schema of SARIF 2.1.0. By hand:

    pip install jsonschema
    scn lint FILE... --format sarif > log.sarif
    python tests/sarif.py sarif-schema-2.1.0.json log.sarif

The schema is OASIS's: https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json
It is not part of this project, for its terms are not those of free software. Not needed to build or
to test; src/diag/sarif.rs has tests of what it writes.
"""

import json
import sys

import jsonschema

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
validator = jsonschema.validators.validator_for(schema)(schema)
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as file:
        log = json.load(file)
    validator.validate(log)
    print(f"{name}: valid, {len(log['runs'][0]['results'])} results")

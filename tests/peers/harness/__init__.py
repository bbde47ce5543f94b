"""scn against its peers; ../README.md tells what is measured, and how."""

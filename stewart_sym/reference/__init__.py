"""Vector implementation against which every kernel is tested; imports only robot and motion."""

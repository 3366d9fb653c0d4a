"""The vector implementation that every kernel is tested against; imports robot and motion alone."""

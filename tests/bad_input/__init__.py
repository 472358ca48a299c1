"""What is refused and how, and files and streams that fail."""

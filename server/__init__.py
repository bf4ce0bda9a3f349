"""The server: a socket for sessions, files for the page, and the command line."""

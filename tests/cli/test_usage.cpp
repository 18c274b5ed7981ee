int unused_cli;

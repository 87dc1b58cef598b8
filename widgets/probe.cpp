int handsight_widgets_probe() { return 0; }

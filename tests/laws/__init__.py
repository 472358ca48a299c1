"""Laws that hold for every number, angle, text and engine, on drawn or chosen examples."""

"""What a page says outside its steps: data, quotations, letters used anew, conclusions.

In: the page as it was read. Out: data for letters, letters that are whole numbers or the time, which
lines are quoted or follow from others, and lines that a symbols file binds to a known quantity.
"""

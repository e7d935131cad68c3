# Reads the last instant of a run's fields.pvd with VTK's own readers. Prints one line per quantity: its name and number.
# Run: python3 read_vtk.py FOLDER. Exit code 3 if VTK is not installed.
import sys
import xml.etree.ElementTree as tree

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(3)

folder = sys.argv[1]
entries = [(float(e.get("timestep")), int(e.get("part")), e.get("file")) for e in tree.parse(folder + "/fields.pvd").iter("DataSet")]
last = max(time for time, _, _ in entries)
files = {part: file for time, part, file in entries if time == last}


def read(reader, part):
    reader.SetFileName(folder + "/" + files[part])
    reader.Update()
    return reader.GetOutput()


blocks = read(vtkXMLUnstructuredGridReader(), 0)
contacts = read(vtkXMLPolyDataReader(), 1)
print("blocks", blocks.GetNumberOfCells())
print("contacts", contacts.GetNumberOfVerts())
print("time", contacts.GetFieldData().GetArray("TimeValue").GetValue(0))

# Forces of contacts on each block.
data = contacts.GetPointData()
force, block, other = (data.GetArray(name) for name in ("force", "block", "other"))
on = {}
for i in range(contacts.GetNumberOfPoints()):
    on[int(block.GetValue(i))] = on.get(int(block.GetValue(i)), 0) + force.GetComponent(i, 1)
    on[int(other.GetValue(i))] = on.get(int(other.GetValue(i)), 0) - force.GetComponent(i, 1)
for number, sum_y in sorted(on.items()):
    print(f"force_y_on_{number}", repr(sum_y))

# Sums of all contacts, for comparison with contacts.csv, and the force from its parts along normal and tangent.
points = range(contacts.GetNumberOfPoints())
for name in ("normal_force", "shear_force", "gap", "slip", "joint", "state"):
    array = data.GetArray(name)
    print(f"sum_{name}", repr(sum(array.GetValue(i) for i in points)))
normal, pressure, shear = (data.GetArray(name) for name in ("normal", "normal_force", "shear_force"))
misfit = 0
for i in points:
    nx, ny = normal.GetComponent(i, 0), normal.GetComponent(i, 1)
    p, s = pressure.GetValue(i), shear.GetValue(i)
    misfit = max(misfit, abs(force.GetComponent(i, 0) - p * nx + s * ny), abs(force.GetComponent(i, 1) - p * ny - s * nx))
print("force_misfit", repr(misfit))

# Corners without their displacement are those of the drawing.
moved = blocks.GetPointData().GetArray("displacement")
heights = [blocks.GetPoint(i)[1] - moved.GetComponent(i, 1) for i in range(blocks.GetNumberOfPoints())]
print("lowest_drawn", repr(min(heights)))
print("highest_drawn", repr(max(heights)))
cells = blocks.GetCellData()
print("held", sum(1 for i in range(blocks.GetNumberOfCells()) if cells.GetArray("fixed_points").GetValue(i) > 0))
least = cells.GetArray("principal_stress_least")
print("most_pressed", repr(min(least.GetValue(i) for i in range(blocks.GetNumberOfCells()))))
if 2 in files:
    bolts = read(vtkXMLPolyDataReader(), 2)
    print("bolts", bolts.GetNumberOfLines())
    print("bolt_force", repr(bolts.GetCellData().GetArray("force").GetValue(0)))

# Reads a run's fields.pvd with VTK's own readers: the last instant, and joints in the whole series. Prints one line per
# quantity: its name and number.
# Run: python3 read_vtk.py FOLDER. Exit code 3 if VTK is not installed.
import csv
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


def read(reader, file):
    reader.SetFileName(folder + "/" + file)
    reader.Update()
    return reader.GetOutput()


def array_of(data, name):
    """Array of this name, with or without a unit."""
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    return data.GetArray(next(n for n in names if n.split(" ")[0] == name))


blocks = read(vtkXMLUnstructuredGridReader(), files[0])
contacts = read(vtkXMLPolyDataReader(), files[1])
print("blocks", blocks.GetNumberOfCells())
print("contacts", contacts.GetNumberOfVerts())
print("time", contacts.GetFieldData().GetArray("TimeValue").GetValue(0))

# Forces of contacts on each block.
data = contacts.GetPointData()
force, block, other = (array_of(data, name) for name in ("force", "block", "other"))
on = {}
for i in range(contacts.GetNumberOfPoints()):
    on[int(block.GetValue(i))] = on.get(int(block.GetValue(i)), 0) + force.GetComponent(i, 1)
    on[int(other.GetValue(i))] = on.get(int(other.GetValue(i)), 0) - force.GetComponent(i, 1)
for number, sum_y in sorted(on.items()):
    print(f"force_y_on_{number}", repr(sum_y))

# Sums of all contacts, for comparison with contacts.csv, and the force from its parts along normal and tangent.
points = range(contacts.GetNumberOfPoints())
for name in ("normal_force", "shear_force", "gap", "slip", "joint", "state"):
    array = array_of(data, name)
    print(f"sum_{name}", repr(sum(array.GetValue(i) for i in points)))
normal, pressure, shear = (array_of(data, name) for name in ("normal", "normal_force", "shear_force"))
misfit = 0
for i in points:
    nx, ny = normal.GetComponent(i, 0), normal.GetComponent(i, 1)
    p, s = pressure.GetValue(i), shear.GetValue(i)
    misfit = max(misfit, abs(force.GetComponent(i, 0) - p * nx + s * ny), abs(force.GetComponent(i, 1) - p * ny - s * nx))
print("force_misfit", repr(misfit))

# Corners without their displacement are those of the drawing.
moved = array_of(blocks.GetPointData(), "displacement")
heights = [blocks.GetPoint(i)[1] - moved.GetComponent(i, 1) for i in range(blocks.GetNumberOfPoints())]
print("lowest_drawn", repr(min(heights)))
print("highest_drawn", repr(max(heights)))
cells = blocks.GetCellData()
print("held", sum(1 for i in range(blocks.GetNumberOfCells()) if array_of(cells, "fixed_points").GetValue(i) > 0))
least = array_of(cells, "principal_stress_least")
print("most_pressed", repr(min(least.GetValue(i) for i in range(blocks.GetNumberOfCells()))))

# Joints of all instants against the rows of contacts.csv: counts and sums per pair of blocks and joint.
COUNTS, SUMS = ("contacts", "closed", "sliding"), ("normal_force", "shear_force")


def joints_of_table():
    """{(step, block, other, joint, material): sums}; contacts have no piece without blocks and joint of their own."""
    with open(folder + "/contacts.csv", newline="") as file:
        rows = [{k.split(" ")[0]: v for k, v in row.items()} for row in csv.DictReader(file)]
    sums = {}
    for row in rows:
        low, high = sorted((int(row["block"]), int(row["other"])))
        own = sums.setdefault((int(row["step"]), low, high, int(row["joint"]), int(row["joint_material"])), [0] * 5)
        for i, value in enumerate((1, row["state"] != "open", row["state"] == "slide", float(row["normal_force"]), float(row["shear_force"]))):
            own[i] += value
    return sums


wanted, seen, misfit, clock = joints_of_table(), 0, 0, 0
for when, part, file in entries:
    if part != 4:
        continue
    joints = read(vtkXMLPolyDataReader(), file)
    clock = max(clock, abs(joints.GetFieldData().GetArray("TimeValue").GetValue(0) - when))
    own = joints.GetCellData()
    for i in range(joints.GetNumberOfLines()):
        key = [int(file[-12:-4])] + [int(array_of(own, n).GetValue(i)) for n in ("block", "other", "joint", "joint_material")]
        numbers = [array_of(own, n).GetValue(i) for n in COUNTS + SUMS]
        expected = wanted.pop(tuple(key))
        seen += 1
        scale = max(1, abs(expected[3]))
        misfit = max(misfit, *(abs(a - b) / (1 if k < 3 else scale) for k, (a, b) in enumerate(zip(numbers, expected))))
print("joint_rows", seen)
print("joints_not_seen", len(wanted))
print("joint_misfit", repr(misfit))
print("clock_misfit", repr(clock))
names = {int(e.get("part")): e.get("name") for e in tree.parse(folder + "/fields.pvd").iter("DataSet")}
print("named_parts", sum(names.get(i) == n for i, n in enumerate(("blocks", "contacts", "bolts", "cracks", "joints"))))
print("length_of_joints", repr(sum(abs(joints.GetCell(i).GetLength2()) ** 0.5 for i in range(joints.GetNumberOfLines()))))
print("forces_with_unit", sum(own.GetArrayName(i) in ("normal_force [N/m]", "shear_force [N/m]") for i in range(own.GetNumberOfArrays())))
if 2 in files:
    bolts = read(vtkXMLPolyDataReader(), files[2])
    print("bolts", bolts.GetNumberOfLines())
    print("bolt_force", repr(array_of(bolts.GetCellData(), "force").GetValue(0)))

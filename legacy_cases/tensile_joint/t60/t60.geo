<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> 0 0.99 0 2.01 </Joint>
<Joint type="1"> 3 0.99 3 2.01 </Joint>
<Joint type="1"> -0.01 1 3.01 1 </Joint>
<Joint type="1"> -0.01 2 3.01 2 </Joint>
<Joint type="1"> 1 -0.01 1 1.01 </Joint>
<Joint type="1"> 2 -0.01 2 1.01 </Joint>
<Joint type="1"> 0.99 0 2.01 0 </Joint>
<Joint type="1"> 0.99 1 2.01 1 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> 0.2 1.5 </Point>
<Point> 2.8 1.5 </Point>
</Fixedpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>

/*! This script holds the following works.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var V_=Object.defineProperty;var G_=(n,t,e)=>t in n?V_(n,t,{enumerable:!0,configurable:!0,writable:!0,value:e}):n[t]=e;var Zf=(n,t,e)=>G_(n,typeof t!="symbol"?t+"":t,e);function G(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s.includes("-")||!(s in i)?i.setAttribute(s,r):i[s]=r;return i.append(...e.flat(1/0).filter(s=>s!=null)),i}function un(n,t){let e=G("i",{},n);return t===null?[e]:[e,G("sub",{},String(t))]}function Jf(n){return G("data",{"data-key":n})}function jf(n,t,e){n.value=String(t),n.title=String(t),n.textContent=e}var su=180/Math.PI;function Jo(n){if(Number.isNaN(n))return"\u2013";if(!Number.isFinite(n))return String(n);let t=Math.abs(n);if(t<5e-13)return"0";if(t<.001||t>=1e6)return n.toExponential(2);let e=t<10?4:t<100?3:t<1e3?2:1;return n.toFixed(e)}function xe(n,t=4){return String(Number(n.toPrecision(t)))}function H_(n){for(let t of[1,2,3,4,6,12]){let e=n/Math.PI*t,i=Math.round(e);if(i===0||Math.abs(e-i)>1e-9)continue;let s=i<0?"-":"",r=Math.abs(i)===1?"":String(Math.abs(i));return`${s}${r}\u03C0${t===1?"":`/${t}`}`}return null}function ru(n){let t=n?"\xB0":"rad";return{inDegrees:n,angleUnit:t,factor:i=>i==="revolute"&&n?su:1,position:i=>i==="revolute"?t:"m",velocity:i=>i==="revolute"?`${t}/s`:"m/s",acceleration:i=>i==="revolute"?`${t}/s\xB2`:"m/s\xB2",force:i=>i==="revolute"?"N m":"N",angle:i=>n?`${xe(i*su)}\xB0`:`${xe(i)} rad`,length:i=>`${xe(i)} m`,number:i=>Math.abs(i)<1e-12?"0":xe(i),cell:i=>n?xe(i*su,6):H_(i)??xe(i,6)}}var Ht=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],qe=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Pt=(n,t)=>[t*n[0],t*n[1],t*n[2]],Ci=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Fn=n=>Math.hypot(n[0],n[1],n[2]),Fs=(n,t)=>Fn(qe(n,t)),Cn=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],ni=n=>Pt(n,1/(Fn(n)||1));function jo(n,t,e){let[i,s]=[Math.sin(e),Math.cos(e)],r=Pt(t,Ci(t,n)*(1-s));return Ht(Ht(Pt(n,s),Pt(Cn(t,n),i)),r)}var Yr={x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]};function Us(n,t){return Ht(Ht(Pt(n.x,t[0]),Pt(n.y,t[1])),Pt(n.z,t[2]))}function fr(n,t){return Ht(n.o,Us(n,t))}function ou({x:n,y:t,z:e,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:Ht(Pt(n,a),Pt(t,o)),y:qe(Pt(t,a),Pt(n,o)),z:e,o:Ht(i,Pt(e,s))}}function au({x:n,y:t,z:e,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:n,y:Ht(Pt(t,a),Pt(e,o)),z:qe(Pt(e,a),Pt(t,o)),o:Ht(i,Pt(n,s))}}function Os(n,{xyz:t,rpy:e}){let[i,s,r]=e.map(Math.sin),[o,a,c]=e.map(Math.cos);return{x:Us(n,[c*a,r*a,-s]),y:Us(n,[c*s*i-r*o,r*s*i+c*o,a*i]),z:Us(n,[c*s*o+r*i,r*s*o-c*i,a*o]),o:fr(n,t)}}function dl(n){let t=Math.atan2(-n[2][0],Math.hypot(n[0][0],n[1][0]));return Math.hypot(n[0][0],n[1][0])<1e-9?[0,t,Math.atan2(-n[0][1],n[1][1])]:[Math.atan2(n[2][1],n[2][2]),t,Math.atan2(n[1][0],n[0][0])]}function Kf(n){if(n.length===1)return n[0];let{x:t,y:e,z:i,o:s}=n.reduce(Os,Yr),r=dl([0,1,2].map(a=>[t[a],e[a],i[a]])),o=a=>a.map(c=>Math.abs(c)<1e-15?0:c);return{xyz:o(s),rpy:o(r)}}function fl(n,t){let e=(i,s)=>n[3*i]*t[s]+n[3*i+1]*t[3+s]+n[3*i+2]*t[6+s];return[0,1,2].flatMap(i=>[0,1,2].map(s=>e(i,s)))}var cu=n=>[n[0],n[3],n[6],n[1],n[4],n[7],n[2],n[5],n[8]],pr=(n,t)=>[0,3,6].map(e=>n[e]*t[0]+n[e+1]*t[1]+n[e+2]*t[2]),lu=n=>n===0?1:Math.sin(n)/n;function hu(n){let t=Fn(n),[e,i]=[lu(t),lu(t/2)**2/2],s=[[1,0,0],[0,1,0],[0,0,1]].map(r=>{let o=Cn(n,r);return Ht(Ht(r,Pt(o,e)),Pt(Cn(n,o),i))});return cu(s.flat())}function Qf(n){let t=Pt([n[7]-n[5],n[2]-n[6],n[3]-n[1]],.5),e=Math.atan2(Fn(t),(n[0]+n[4]+n[8]-1)/2);return Pt(t,1/lu(e))}function W_(n){let t=n*n;return n<.01?1/12+t*(1/720+t/30240):(1-n/2/Math.tan(n/2))/t}function uu(n,t){let e=Cn(n,t);return Ht(Ht(t,Pt(e,.5)),Pt(Cn(n,e),W_(Fn(n))))}var $r=[0,1,2,3,4,5].map(n=>{let t="xyz"[n%3];return n<3?{name:`base.v${t}`,axis:t,velocity:"v",force:"f",type:"prismatic"}:{name:`base.w${t}`,axis:t,velocity:"\u03C9",force:"n",type:"revolute"}}),ep=["x","y","z","roll","pitch","yaw"].map((n,t)=>({name:n,type:t<3?"prismatic":"revolute"})),tp=n=>n.slice(0,9),ji=n=>n.slice(9,12);function np([n,t,e,...i]){let s=Os(Yr,{xyz:[n,t,e],rpy:i});return[0,1,2].flatMap(r=>[s.x[r],s.y[r],s.z[r]]).concat(s.o)}function ip(n){let[t,e,i]=[0,1,2].map(s=>[n[s],n[3+s],n[6+s]]);return{x:t,y:e,z:i,o:ji(n)}}var pl=class{constructor(t){this.rotation=tp(t),this.start=[0,0,0,...ji(t)]}pose(t){return[...fl(this.rotation,hu(t.subarray(0,3))),...t.subarray(3,6)]}rate(t,e,i){return[...uu(t.subarray(0,3),i.slice(3,6)),...pr(e,i)]}recenter(t){this.rotation=tp(this.pose(t)),t.fill(0,0,3)}};function du(n,t,e,i){let[s,r]=[t-n,n-e];return i*(n+(1-i)*(s*(1-i)+r*i))}function sp([n,t],[e,i],s,r){let o=Qf(fl(cu(n),t)),a=(d,u,m)=>d.map((g,x)=>du(g,s*u[x],s*m[x],r)),c=a(o,e.slice(3,6),uu(o,i.slice(3,6))),l=Ht(ji(t),Pt(ji(n),-1)),h=a(l,pr(n,e),pr(t,i));return[...fl(n,hu(c)),...Ht(ji(n),h)]}var X_="\u0307",ml=n=>({min:()=>-n,max:()=>n}),Zr=({state:n,changed:t},e,i)=>({get:()=>n[e][i],set(s){n[e][i]=s,t()}}),fu=({units:n},t)=>({factor:()=>n().factor(t),unit:()=>n().position(t)}),pu=n=>({state:n.state,changed:n.changed,units:()=>n.units});function rp(n,t,{signs:e,name:i,most:s}){let{state:r}=n,{type:o}=n.freedoms[t],a=pu(n),c={...ml(2*s.speed),...fu(a,o),...Zr(a,"qd",t),unit:()=>n.units.velocity(o),label:e.velocity,key:`qd-${t}`,about:`${i}, velocity${r.mode==="pose"?"":" at the start"}`};if(r.mode==="pose"){let h={...c,...ml(4*s.speed),...Zr(a,"qdd",t),unit:()=>n.units.acceleration(o),label:e.acceleration,key:`qdd-${t}`,about:`${i}, acceleration`};return[c,h]}if(r.law!=="constant")return[c];let l={...ml(s.force),...Zr(a,"torque",t),factor:()=>1,unit:()=>n.units.force(o),label:e.force,key:`tau-${t}`,about:`${i}, ${o==="revolute"?"torque":"force"}`};return[c,l]}function op(n,t){let{state:e}=n,i=n.joints[t],[s,r]=n.ranges[t],o=pu(n),a={min:()=>s,max:()=>r,...fu(o,i.type)},c={...a,...Zr(o,"q",t),label:e.mode==="motion"?"start":un("q",null),key:`q-${t}`,about:`${i.name}, position${e.mode==="pose"?"":" at the start"}`};if(e.mode==="motion"){let u={...a,...Zr(o,"end",t),label:"end",key:`end-${t}`,about:`${i.name}, position at the end`};return[c,u]}let l=Math.max(1,...n.table.rows.map(u=>u.mass))*9.81,h={velocity:un("q\u0307",null),acceleration:un("q\u0308",null),force:un("\u03C4",null)},d=i.type==="revolute"?{speed:Math.PI,force:l*n.size}:{speed:n.size,force:l};return[c,...rp(n,n.ofBase+t,{signs:h,name:i.name,most:d})]}function ap(n){let{state:t,size:e}=n,i=pu(n),s=ep.map(({name:l,type:h},d)=>({...ml(h==="revolute"?Math.PI:Math.max(2*e,1)),...fu(i,h),...Zr(i,"pose",d),label:l,key:`pose-${d}`,about:`base, ${l}${t.mode==="free"?" at the start":""}`}));if(t.mode==="motion")return s;let{rows:r,floating:o}=n.table,a=9.81*r.reduce((l,{mass:h})=>l+h,o.mass),c=n.freedoms.slice(0,n.ofBase).map(({name:l,axis:h,velocity:d,force:u,type:m},g)=>{let x={velocity:un(d,h),acceleration:un(`${d}${X_}`,h),force:un(u,h)},p=m==="revolute"?{speed:Math.PI,force:a*e}:{speed:Math.max(2*e,2),force:2*a};return rp(n,g,{signs:x,name:l,most:p})});return[...s,...c.map(([l])=>l),...c.flatMap(([,l])=>l??[])]}var Ko=class extends Error{constructor(t){super(`not positive definite at index ${t}`),this.joint=t}};function gl(n,t,e){let i=e.length,s=e.map(()=>new Array(i).fill(0)),r=e.map(o=>t[o]);for(let o=0;o<i;o++){for(let a=0;a<=o;a++){let c=n[e[o]][e[a]];for(let l=0;l<a;l++)c-=s[o][l]*s[a][l];if(o===a&&!(c>1e-14*Math.abs(n[e[o]][e[o]])))throw new Ko(e[o]);s[o][a]=o===a?Math.sqrt(c):c/s[a][a]}for(let a=0;a<o;a++)r[o]-=s[o][a]*r[a];r[o]/=s[o][o]}for(let o=i-1;o>=0;o--){for(let a=o+1;a<i;a++)r[o]-=s[a][o]*r[a];r[o]/=s[o][o]}return r}var mu=$r.map((n,t)=>t),lp={none:()=>(n,t,e)=>e.map(()=>0),constant:({torque:n})=>()=>n,gravity:({equations:n})=>(t,e)=>{let i=n.spring_vector(e);return n.gravity_vector(t,e).map((s,r)=>s+i[r])},steady:({equations:n,hasFriction:t})=>(e,i,s)=>{let r=n.inverse_dynamics(e,i,s,s.map(()=>0)),o=n.mass_matrix(i),a=gl(o,r.map(l=>-l),mu),c=t?null:n.friction_vector(s);return r.map((l,h)=>h<mu.length?0:mu.reduce((d,u)=>d+o[h][u]*a[u],l-(c?.[h]??0)))}};function cp({floating:n}){let t="none: free fall";return n?{none:t,steady:"of joints: they keep their velocities",constant:"constant, on the base too",gravity:"G + K, on the base too: the robot floats"}:{none:t,constant:"constant",gravity:"G + K: the arm floats"}}function _l({label:n,key:t,min:e,max:i,get:s,set:r,factor:o,unit:a,about:c}){let l=G("input",{type:"range",step:"any","data-key":t,"aria-label":c}),h=G("input",{type:"number",step:"any","aria-label":`${c}, as a number`}),d=G("span",{class:"unit"}),u=G("p",{class:"refused",role:"alert"}),m=G("div",{class:"slider"},G("span",{class:"what"},n),l,h,d,u),g=()=>{let[p,f]=[s(),o()],[M,P]=[Math.min(e(),p),Math.max(i(),p)];Object.assign(l,{min:M*f,max:P*f}),l.value=p*f,l.setAttribute("aria-valuetext",`${xe(p*f)} ${a()}`),(document.activeElement!==h||u.textContent)&&(h.value=xe(p*f,5)),d.textContent=a()},x=p=>{let f=Number(p)/o(),M=p.trim()!==""&&Number.isFinite(f),P=M?r(f):"expected a number";u.textContent=P?`${M?`${p} is refused: `:""}${P}`:"",g()};return l.addEventListener("input",()=>x(l.value)),h.addEventListener("change",()=>x(h.value)),g(),{row:m,show:g}}var q_={motion:"Motion",free:"Free motion",pose:"Pose"},Y_={motion:"From start to end, from rest to rest; inverse dynamics gives the torques.",free:"From the start under given torques; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes."},$_={motion:"The base is held where it is, and the joints go from start to end, from rest to rest; inverse dynamics gives the torques, and the force and the moment that hold the base.",free:"Base and joints move freely from the start; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes, and the force and the moment on the base."};function Z_(n,{name:t,value:e,unit:i}){let s=i==="rad",[r,o]=s?[-Math.PI,Math.PI]:e<0?[3*e,0]:[0,3*e||1];return _l({label:G("i",{},t),key:`field-${t}`,about:i?`field ${t}`:`field ${t}, without unit`,min:()=>r,max:()=>o,get:()=>n.fields[t],set:a=>n.setFields({[t]:a}),factor:()=>s?n.units.factor("revolute"):1,unit:()=>s?n.units.angleUnit:i})}function hp({about:n,key:t,options:e,get:i,set:s}){let r=Object.entries(e).map(([a,c])=>G("option",{value:a},c)),o=G("select",{"data-key":t,onchange:()=>s(o.value)},r);return o.value=i(),G("label",{class:"choice"},G("span",{},n),o)}function J_({rows:n},t){let{on:e}=n[t];return n.filter(s=>!s.isPlace&&s.on===e).length>1||(e??-1)!==t-1?`on ${e===null?"the base":n[e].name}`:null}function up(n){let{state:t,joints:e,first:i}=n,s=[],r=Object.entries(q_).map(([L,T])=>G("button",{type:"button",role:"tab","data-key":`mode-${L}`,onclick:()=>n.setMode(L)},T)),o=G("div",{class:"tabs",role:"tablist","aria-label":"Kind of motion"},r);o.addEventListener("keydown",({key:L})=>{let T={ArrowRight:1,ArrowLeft:-1}[L];if(!T)return;let b=r.findIndex(F=>F.getAttribute("aria-selected")==="true"),D=r[(b+T+r.length)%r.length];D.focus(),D.click()});let a=G("p",{class:"said"}),c=G("div",{class:"settings"}),l=G("div",{class:"joints"}),h=G("div",{role:"tabpanel"},a,c,l),d=G("input",{type:"number",min:"0.1",max:"60",step:"any","data-key":"duration"}),u=G("p",{class:"refused",role:"alert"});d.addEventListener("change",()=>{let L=Number(d.value);u.textContent=L>0?"":"expected a number above zero",L>0&&(t.duration=Math.min(L,60)),d.value=t.duration,n.changed()});let m={cycloidal:"cycloidal",quintic:"quintic polynomial",cubic:"cubic polynomial"},g=cp(n.table),x=n.table.floating?$_:Y_,p=n.table.rows.some(L=>L.viscous!==0||L.coulomb.some(T=>T!==0)||L.stribeck);function f(){r.forEach(T=>{let b=T.dataset.key===`mode-${t.mode}`;T.setAttribute("aria-selected",b),T.tabIndex=b?0:-1}),a.textContent=x[t.mode],d.value=t.duration;let L=[];if(t.mode!=="pose"&&L.push(G("label",{class:"choice"},G("span",{},"duration, s"),d),u),t.mode==="motion"){let T=b=>{t.profile=b,n.changed()};L.push(hp({about:"profile",key:"profile",options:m,get:()=>t.profile,set:T}))}if(t.mode==="free"){let T=b=>{t.law=b,f(),n.changed()};if(L.push(hp({about:"torques",key:"law",options:g,get:()=>t.law,set:T})),p){let b=G("input",{type:"checkbox",checked:t.hasFriction,"data-key":"friction"});b.addEventListener("change",()=>{t.hasFriction=b.checked,n.changed()}),L.push(G("label",{class:"check"},b,"friction"))}}c.replaceChildren(...L),s.length=0,l.replaceChildren(...n.table.floating?[M()]:[],...e.flatMap((T,b)=>{let D=op(n,b).map(_l);s.push(...D);let F=n.table.rows.findIndex(Z=>Z.joint===b),I=G("button",{type:"button",class:"name",onclick:()=>n.select(F)});I.append(G("span",{class:"dot"}),G("b",{},String(b+1)),` ${T.name}`);let O=G("span",{class:"kind"},T.type),H=G("span",{class:"kind limits"}),z=G("div",{class:"head"},I,O,H),Q=G("div",{class:"joint","data-joint":b},z,D.map(Z=>Z.row));Q.addEventListener("focusin",()=>n.select(F));let Y=J_(n.table,F);return Y===null?Q:[G("h3",{class:"branch"},Y),Q]})),S(),P()}function M(){let L=ap(n).map(_l);s.push(...L);let T=G("span",{class:"name"},G("b",{},"base")),b=G("span",{class:"kind"},"velocities and forces in its own axes");return G("div",{class:"joint base"},G("div",{class:"head"},T,b),L.map(D=>D.row))}function P(){let{factor:L,position:T}=n.units;l.querySelectorAll(".limits").forEach((b,D)=>{let{limits:F,type:I}=e[D],O=F?.map(H=>xe(H*L(I),4));b.textContent=O?`${O[0]} to ${O[1]} ${T(I)}`:"no limits"})}function S(){l.querySelectorAll("[data-joint]").forEach((L,T)=>{let{selected:b}=t;L.classList.toggle("selected",n.table.rows[b]?.joint===T),L.style.setProperty("--color",`var(--joint-${T%8})`)})}let C=i.fields.map(L=>Z_(n,L)),E=G("div",{class:"fields"},G("h3",{},"Parameters"),C.map(L=>L.row));n.on("mode",f),n.on("units",()=>{[...s,...C].forEach(L=>L.show()),P()}),n.on("selection",S),f();let _=G("button",{type:"button",class:"quiet",onclick(){let L=F=>t[F].fill(0);["qdd","torque"].forEach(L),["pose","qd"].forEach(F=>v[F].forEach((I,O)=>t[F][O]=I));let{from:T,to:b,duration:D}=i;v.q.forEach((F,I)=>t.q[I]=T?.[I]??F),v.end.forEach((F,I)=>t.end[I]=b?.[I]??F),t.duration=D,n.setFields(Object.fromEntries(i.fields.map(({name:F,value:I})=>[F,I]))),f(),C.forEach(F=>F.show()),n.changed()}});_.append("Reset");let v={q:[...t.q],end:[...t.end],pose:[...t.pose],qd:[...t.qd]};return G("section",{class:"panel controls","aria-label":"Settings"},G("div",{class:"bar"},o,_),h,i.fields.length>0?E:null)}var j_=[[0,1],[0,2],[1,2]];function K_([n,t,e,i,s,r]){let o=[[n,i,r],[i,t,s],[r,s,e]],a=[[1,0,0],[0,1,0],[0,0,1]];for(let c=0;c<12;c++)for(let[l,h]of j_){if(o[l][h]===0)continue;let d=Math.atan2(2*o[l][h],o[h][h]-o[l][l])/2,[u,m]=[Math.sin(d),Math.cos(d)],g=x=>x.forEach(p=>[p[l],p[h]]=[m*p[l]-u*p[h],u*p[l]+m*p[h]]);g(o),[o[l],o[h]]=[o[l].map((x,p)=>m*x-u*o[h][p]),o[l].map((x,p)=>u*x+m*o[h][p])],g(a)}return{moments:[o[0][0],o[1][1],o[2][2]],axes:a}}function xl({mass:n,inertia:t}){let{moments:e,axes:i}=K_(t),s=e[0]+e[1]+e[2],r=e.map(l=>n>0?Math.sqrt(Math.max(0,6*(s-2*l)/n))/2:0),[o,a,c]=[0,1,2].map(l=>i.map(h=>h[l]));return{x:o,y:a,z:c,half:r}}function Q_(n,t){return n.rows.map(e=>e.joint!==null?t[e.joint]:e.follows?e.follows.factor*t[e.follows.joint]+e.follows.offset:e.locked)}function Bs(n,t,e){let i=e?ip(e):n.base?Os(Yr,n.base):Yr,s=Q_(n,t),r=[];n.rows.forEach((a,c)=>{let l=a.on===null?i:r[a.on].frame,h=a.step.reduce(Os,l),d=a.type==="prismatic",u=a.theta+(d?0:s[c]),m=a.d+(d?s[c]:0),g=(p,f,M)=>{let P=a.mount?a.mount.frame.reduce(Os,f):f;r.push({before:h,middle:p,frame:f,link:P,theta:u,d:m,origin:M.o,axis:M.z})};if(n.convention==="standard"){let p=ou(h,m,u);g(p,au(p,a.a,a.alpha),h);return}let x=au(h,a.a,a.alpha);g(x,ou(x,m,u),x)});let o=n.tips.map(({on:a,places:c})=>c.reduce(Os,a===null?i:r[a].link));return{base:i,rows:r,tips:o}}function dp(n,t){let e=new Array(n.joints).fill(0),{base:i,rows:s,tips:r}=Bs(n,e,null),o=[],a=u=>u===null?{way:0,at:i.o}:o[u],c=({way:u,at:m},g)=>({way:u+Fs(m,g),at:g});s.forEach(({middle:u,frame:m,link:g},x)=>{let{on:p,isPlace:f}=n.rows[x],M=n.isMounted?f?[]:[g.o]:[u.o,m.o];o.push(M.reduce(c,a(p)))});let l=n.tips.map(({on:u},m)=>c(a(u),r[m].o).way),h=Math.max(0,...o.map(({way:u})=>u),...l)+t,d=n.rows.map(u=>Math.hypot(...u.com));if(n.floating){let{com:u}=n.floating;d.push(Fn(Ht(u,xl(n.floating).half)))}return Math.max(h,...d)||1}function fp(n,t,e){let i=t.slice(0,6).map(a=>a.reduce((c,l,h)=>c+l*e[h],0)),[s,r]=[i.slice(0,3),i.slice(3)],o=Pt([t[1][5],t[2][3],t[0][4]],1/(t[0][0]||1));return{linear:pr(n,s),angular:pr(n,qe(r,Cn(o,s)))}}var tx=["mass_matrix","coriolis_vector","kinetic_energy","friction_vector","spring_vector"];function pp(n,t,e){let i=Object.keys(n).filter(o=>/^[a-z]/.test(o)),s=n.FIELD_NAMES!==void 0,r=o=>{let a=s?(...c)=>n[o](t,...c):n[o];return e||tx.includes(o)?a:(c,...l)=>a(...l)};return Object.fromEntries(i.map(o=>[o,r(o)]))}function mp(n,{base:t,q:e,qd:i,qdd:s,tau:r},{key:o}){let a=n.gravity_vector(t,e),c=n.friction_vector(i),l=n.spring_vector(e),h=n.mass_matrix(e),d=n.inverse_dynamics(t,e,i,i.map(()=>0));return{base:t,q:e,qd:i,qdd:s,tau:r,mass:h,momentum:t&&fp(t,h,i),coriolis:d.map((u,m)=>u-a[m]-l[m]-c[m]),gravity:a,friction:c,spring:l,tip:n[o](t,e),kinetic:n.kinetic_energy(e,i),potential:n.potential_energy(t,e)}}var xp=n=>typeof n=="number"?[n]:n&&typeof n=="object"?Object.values(n).flatMap(xp):[];function gp([n,t,e,i,s,r],o){return[[[n,t,e],o],[[n*t-i*i,t*e-s*s,n*e-r*r],o**2],[[n*(t*e-s*s)-i*(i*e-s*r)+r*(i*s-t*r)],o**3]].every(([c,l])=>c.every(h=>h>=-1e-9*l))}function ex([n,t,e,i,s,r]){let o=Math.max(...[n,t,e,i,s,r].map(Math.abs));if([n,t,e].filter(l=>l!==0).length<2&&Math.min(n,t,e)>=0&&i===0&&s===0&&r===0)return null;let a=(n+t+e)/2;return gp([n,t,e,i,s,r],o)&&gp([a-n,a-t,a-e,-i,-s,-r],o)?null:"no body has this inertia tensor"}function _p(n){if(xp(n).some(e=>!Number.isFinite(e)))return"division by zero, or a number that is too large";let t=[[n.mass,"a mass"],[n.motorInertia,"a motor's inertia"],[n.viscous,"a friction coefficient"],[Math.min(...n.coulomb??[]),"a friction torque or force"],[n.stribeck?.friction,"a friction torque or force"],[n.spring?.stiffness,"a spring's stiffness"]].find(([e])=>e<0);return t?`${t[1]} cannot be negative`:n.motorInertia>0&&n.gearRatio===0?"a gear ratio of zero: a motor with inertia turns with its joint":n.stribeck&&!(n.stribeck.velocity>0)?"a Stribeck velocity is above zero":ex(n.inertia)}function yp(n,t){let e=({rows:s,tool:r,base:o,floating:a,gravity:c})=>[...s,r,a,o&&{inertia:[0,0,0,0,0,0],base:o},{inertia:[0,0,0,0,0,0],gravity:c}],i=e(t);for(let[s,r]of e(n).entries()){let o=r&&_p(r);if(o&&o!==_p(i[s]))return r.name?`\`${r.name}\`: ${o}`:o}return null}function vp(){let n=new Map;return{on(t,e){for(let i of t.split(" "))n.set(i,[...n.get(i)??[],e])},tell(t){(n.get(t)??[]).forEach(e=>e())}}}var gu=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],yl=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]],[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]]],Sp=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],Mp=[[0,.2440944881889764],[8,.7338466882816118],[11,.022058823529411766]];var nx=1e-10;function Qo(n,t,e,i){let s=Float64Array.from(n);for(let[r,o]of e){let a=i[r];for(let c=0;c<s.length;c++)s[c]+=t*o*a[c]}return s}function vl(n,t,e,i,s){let r=[i];for(let g=1;g<gu.length;g++)r.push(n(t+gu[g]*s,Qo(e,s,yl[g],r)));let o=Qo(e,s,yl[12],r),a=new Float64Array(e.length),c=Qo(a,1,yl[12],r),l=Qo(a,1,Mp,r),h=Qo(a,1,Sp,r),[d,u]=[0,0];for(let g=0;g<e.length;g++){let x=nx*(1+Math.max(Math.abs(e[g]),Math.abs(o[g])));d+=(h[g]/x)**2/e.length,u+=((c[g]-l[g])/x)**2/e.length}let m=d===0?0:s*d/Math.sqrt(d+.01*u);return{end:o,error:m}}function _u(n,t){if(!Number.isFinite(n))return 1/3;let e=.9*n**(-1/8);return Math.min(Math.max(e,1/3),t?1:6)}function ix(n){let t=Array.from({length:n.dof},()=>[]),e=n.dof-n.joints;for(let i of n.rows)i.joint!==null?t[e+i.joint].push({row:i,factor:1}):i.follows&&t[e+i.follows.joint].push({row:i,factor:i.follows.factor});return t}var bp=(n,t)=>t>0?n.coulomb[0]:n.coulomb[1],sx=(n,t)=>n.stribeck?n.stribeck.friction:bp(n,t);function wp(n){let t=ix(n);return{isDry:t.map(e=>e.some(({row:i})=>i.coulomb[0]!==0||i.coulomb[1]!==0||i.stribeck!==null)),breakaway:(e,i)=>t[e].reduce((s,{row:r,factor:o})=>s+Math.abs(o)*sx(r,i*Math.sign(o)),0),sliding:(e,i,s)=>t[e].reduce((r,{row:o,factor:a})=>{let c=a*s,l=Math.sign(a)*i,h=bp(o,l),d=o.stribeck?(o.stribeck.friction-h)*Math.exp(-((c/o.stribeck.velocity)**2)):0;return r+a*(o.viscous*c+l*(h+d))},0)}}var rx=6e5,ox=200;function ax(n,t){let e=t-(n.dof-n.joints);if(e<0)return"the mass matrix is singular at the base: no inertia resists its motion";let{name:i}=n.rows.find(s=>s.joint===e);return`the mass matrix is singular at joint ${e+1}, \`${i}\`: no inertia resists its motion`}var Jr=class extends Error{},xu=class{constructor(t,e,i,s,r){Zf(this,"rate",(t,e)=>{let i=this.state(e),{base:s,qd:r}=i,{tau:o,friction:a,qdd:c}=this.solve(i),l=r.reduce((h,d,u)=>h+d*(o[u]-a[u]),0);return this.chart?Float64Array.from([...this.chart.rate(e,s,r),...r.slice(this.ofBase),...c,l]):Float64Array.from([...r,...c,l])});this.chart=i&&new pl(i),this.ofBase=e.dof-e.joints,this.equations=t,this.torque=s,this.hasFriction=r,this.dry=wp(e),this.dof=e.dof,this.evaluations=0,this.contacts=new Array(e.dof).fill(0),this.sticks=r&&this.dry.isDry.some(Boolean)}friction(t){return this.hasFriction?t.map((e,i)=>{let s=this.contacts[i];return s===null?0:this.dry.sliding(i,s||Math.sign(e),e)}):t.map(()=>0)}solve({base:t,q:e,qd:i}){if(++this.evaluations>rx)throw new Jr("it takes too many steps");let s=this.torque(t,e,i),r=this.friction(i);if(!this.contacts.includes(null)){let g=this.equations.friction_vector(i),x=s.map((p,f)=>p+(g[f]-r[f]));return{tau:s,friction:r,qdd:this.equations.forward_dynamics(t,e,i,x),hold:null}}let o=i.map(()=>0),a=this.equations.friction_vector(i),c=this.equations.inverse_dynamics(t,e,i,o).map((g,x)=>g-a[x]),l=this.equations.mass_matrix(e),h=this.contacts.flatMap((g,x)=>g===null?[]:[x]),d=s.map((g,x)=>g-c[x]-r[x]),u=o;gl(l,d,h).forEach((g,x)=>u[h[x]]=g);let m=s.map((g,x)=>this.contacts[x]!==null?0:l[x].reduce((p,f,M)=>p-f*u[M],g-c[x]));return{tau:s,friction:r,qdd:u,hold:m}}state(t){let e=this.dof;return{base:this.chart&&this.chart.pose(t),q:Array.from(t.subarray(this.ofBase,e)),qd:Array.from(t.subarray(e,2*e))}}margins(t){if(!this.sticks)return[1/0];let e=this.state(t),i=this.contacts.includes(null)?this.solve(e).hold:null;return this.contacts.map((s,r)=>s===null?this.dry.breakaway(r,Math.sign(i[r]))-Math.abs(i[r]):s===0?1/0:s*e.qd[r])}settle(t){if(!this.sticks)return;let e=this.state(t);for(this.contacts=e.qd.map((i,s)=>this.dry.isDry[s]?i===0?null:Math.sign(i):0);this.contacts.includes(null);){let{hold:i}=this.solve(e),s=this.contacts.map((o,a)=>o!==null||i[a]===0?0:Math.abs(i[a])/this.dry.breakaway(a,Math.sign(i[a]))),r=s.indexOf(Math.max(...s));if(!(s[r]>1))return;this.contacts[r]=Math.sign(i[r])}}};function lx(n,t,e,i,s){let[r,o]=[0,s];for(let a=0;a<60&&o-r>1e-12*s;a++){let c=(r+o)/2,{end:l}=vl(n.rate,t,e,i,c);Math.min(...n.margins(l))<0?o=c:r=c}return o}function cx(n,t,e){let{t:i,y:s,h:r}=t,o=0,a=!1;for(;e-i>1e-12*Math.max(1,e);){let c=n.rate(i,s),l=Math.min(r,e-i),{end:h,error:d}=vl(n.rate,i,s,c,l);if(!(d<=1)){if(r=l*_u(d,!0),a=!0,!(r>1e-12))throw new Jr("its steps become too small");continue}if(Math.min(...n.margins(h))<0){if(++o>ox)throw new Jr("a joint sticks and lets go without end");let m=lx(n,i,s,c,l);s=vl(n.rate,i,s,c,m).end,i+=m,n.chart?.recenter(s),n.contacts.forEach((g,x)=>{g&&g*s[n.dof+x]<=0&&(s[n.dof+x]=0)}),n.settle(s);continue}[i,s]=[i+l,h],n.chart?.recenter(s);let u=l*_u(d,a);r=l<r&&d<.1?Math.max(r,u):u,a=!1}return{t:e,y:s,h:r}}function Ep({equations:n,table:t,law:e,torque:i,hasFriction:s,base:r,q:o,qd:a,duration:c,samples:l}){let h=lp[e]({equations:n,torque:i,hasFriction:s}),d=new xu(n,t,r,h,s),u={t:[],base:[],q:[],qd:[],qdd:[],tau:[],work:[],ended:null},m={t:0,y:Float64Array.from([...d.chart?.start??[],...o,...a,0]),h:c/l};try{d.settle(m.y);for(let g=0;g<l;g++){let x=c*g/(l-1);m=cx(d,m,x);let p=d.state(m.y),{qdd:f,tau:M}=d.solve(p);u.t.push(x),u.base.push(p.base),u.q.push(p.q),u.qd.push(p.qd),u.qdd.push(f),u.tau.push(M),u.work.push(m.y[2*d.dof])}}catch(g){let x=g instanceof Ko||g.name==="SingularMassMatrix";if(!(g instanceof Jr)&&!x)throw g;u.ended={t:m.t,reason:x?ax(t,g.joint):g.message}}return u}var ta=2*Math.PI,hx={cycloidal:n=>[n-Math.sin(ta*n)/ta,1-Math.cos(ta*n),ta*Math.sin(ta*n)],quintic:n=>[n**3*(10+n*(6*n-15)),30*n**2*(1-n)**2,60*n*(1-n)*(1-2*n)],cubic:n=>[n*n*(3-2*n),6*n*(1-n),6-12*n]};function Tp({from:n,to:t,duration:e,profile:i},s){let[r,o,a]=hx[i](Math.min(Math.max(s/e,0),1)),c=l=>n.map((h,d)=>l(t[d]-h,h));return{q:c((l,h)=>h+l*r),qd:c(l=>l*o/e),qdd:c(l=>l*a/e**2)}}var ux=100,[dx,fx]=[201,2001];function Ap(n){return Math.min(Math.max(Math.round(ux*n)+1,dx),fx)}function Rp(n,t){let e=Ap(t.duration),{base:i}=t,s=i?$r.map(()=>0):[],r=h=>{let{q:d,...u}=Tp(t,h),[m,g]=[u.qd,u.qdd].map(x=>[...s,...x]);return{base:i,q:d,qd:m,qdd:g,tau:n.inverse_dynamics(i,d,m,g)}},o=Array.from({length:e},(h,d)=>t.duration*d/(e-1)),a=o.map(r),c=h=>a.map(d=>d[h]),l={t:o,base:c("base"),q:c("q"),qd:c("qd"),qdd:c("qdd"),tau:c("tau")};return Pp(n,{...l,at:r,ended:null,duration:t.duration},t)}function Cp(n,t){let e=Ep({...t,equations:n,samples:Ap(t.duration)});e.t.length===0&&px(e,t);let i=e.t.length>0?e.t[e.t.length-1]:0,s=Pp(n,{...e,duration:i,at:h=>mx(e,h)},t),{total:r,kinetic:o,potential:a}=s,c=r.map((h,d)=>Math.abs(h-r[0]-e.work[d])),l=h=>Math.max(...h)-Math.min(...h);return s.drift=Math.max(0,...c),s.energyScale=Math.max(l(o),l(a),l(e.work),0),s}function px(n,{base:t,q:e,qd:i}){let s=i.map(()=>NaN);for(let[r,o]of Object.entries({t:0,base:t,q:e,qd:i,qdd:s,tau:s,work:0}))n[r].push(o)}function Pp(n,t,{key:e}){let{base:i,q:s,qd:r}=t,o=s.map((h,d)=>n.kinetic_energy(h,r[d])),a=s.map((h,d)=>n.potential_energy(i[d],h)),c=o.map((h,d)=>h+a[d]),l=s.map((h,d)=>n[e](i[d],h).slice(0,3).map(u=>u[3]));return{...t,kinetic:o,potential:a,total:c,tip:l}}function mx(n,t){let{t:e}=n,i=e.length-1,s=m=>Object.fromEntries(["base","q","qd","qdd","tau"].map(g=>[g,n[g][m]]));if(i<1)return s(0);let r=e[1]-e[0],o=Math.min(Math.max(Math.floor(t/r),0),i-1),a=Math.min(Math.max((t-e[o])/r,0),1);if(a===0||a===1)return s(o+a);let[c,l]=[s(o),s(o+1)],h=c.qd.length-c.q.length,d=(m,g,x)=>c[m].map((p,f)=>p+du(l[m][f]-p,r*c[g][x+f],r*l[g][x+f],a)),u=m=>m[o].map((g,x)=>g+a*(m[o+1][x]-g));return{base:c.base&&sp([c.base,l.base],[c.qd,l.qd],r,a),q:d("q","qd",h),qd:d("qd","qdd",0),qdd:u(n.qdd),tau:u(n.tau)}}function Ip(n,t){let e=["q","qd","qdd","tau"],[i]=n.base,s=h=>t.slice(t.length-n[h][0].length),r=e.flatMap(h=>s(h).map(d=>`${h}_${d}`)),a=[...[1,2,3].flatMap(h=>[1,2,3].map(d=>`r${h}${d}`)),"x","y","z"].map(h=>`base.${h}`),c=["t",...i?a:[],...r,"kinetic","potential","x","y","z"],l=n.t.map((h,d)=>[h,...n.base[d]??[],...e.flatMap(u=>n[u][d]),n.kinetic[d],n.potential[d],...n.tip[d]]);return[c,...l].map(h=>h.join(",")).join(`
`)+`
`}var gx=30;function _x(n,t){return n.limits?n.limits:n.type==="revolute"?[-Math.PI,Math.PI]:[-t,t]}function xx([n,t]){return n<=0&&t>=0?0:(n+t)/2}var Lp=[0,0,0,.1,1.5,.3],Dp=[60,40,-50,30,70,-40];function yx(n,{type:t,joint:e},[i,s]){let r=Dp[e%Dp.length],o=t==="revolute"?r*Math.PI/180:(s-i)*r/240,[a,c]=[n+o,n-o],l=h=>h>=i&&h<=s;return l(a)?a:l(c)?c:o>0?s:i}function Np(n,t,e){let{on:i,tell:s}=vp(),r=Object.fromEntries(e.fields.map(({name:S,value:C})=>[S,C])),o=n(r),a=o.floating!==null,c=pp(t,r,a),l=o.rows.filter(S=>S.type==="prismatic"&&S.joint!==null).reduce((S,C)=>S+(C.limits?Math.max(...C.limits.map(Math.abs)):0),0),h=dp(o,l),d=o.rows.filter(S=>S.joint!==null),u=d.map(S=>_x(S,h)),m=[...a?$r:[],...d],g=m.map(()=>0),x=e.from??u.map(xx),p={mode:"motion",pose:[...e.pose??[0,0,0,0,0,0]],q:[...x],qd:[...e.velocity??(a?[...Lp,...g.slice(Lp.length)]:g)],qdd:[...g],end:e.to??x.map((S,C)=>yx(S,d[C],u[C])),torque:[...g],profile:"cycloidal",law:"none",hasFriction:!0,duration:e.duration,t:0,isPlaying:!1,isRepeated:!1,speed:1,selected:o.rows.indexOf(d[0]),tip:0,show:{parameters:"selected",frames:!1,axes:!1,masses:!1,trace:!0,names:!1,isFollowed:!0}},f={on:i,tell:s,state:p,first:e,fields:r,equations:c,table:o,size:h,joints:d,freedoms:m,ofBase:m.length-d.length,ranges:u,trajectory:null,units:ru(!0),now(){if(p.mode==="pose"){let{q:S,qd:C,qdd:E}=p,_=f.start();return{base:_,q:S,qd:C,qdd:E,tau:c.inverse_dynamics(_,S,C,E)}}return f.trajectory.at(p.t)},start:()=>a?np(p.pose):null,tip:()=>o.tips[p.tip],evaluated:()=>mp(c,f.now(),f.tip()),frames(){let{base:S,q:C}=f.now();return Bs(f.table,C,S)},setTime(S){let C=f.trajectory?.duration??0;p.t=Math.min(Math.max(S,0),C),s("time")},play(S){f.trajectory&&(p.isPlaying=S,S&&p.t>=f.trajectory.duration&&f.setTime(0),s("play"))},setMode(S){p.mode=S,p.isPlaying=!1,p.t=0,f.recompute(),s("mode"),s("time"),s("play")},changed(){p.isPlaying=!1,p.t=0,s("play"),f.ask()},setFields(S){let C=n({...r,...S}),E=yp(C,o);return E||(Object.assign(r,S),f.table=C,s("fields"),f.changed(),null)},setUnits(S){f.units=ru(S),s("units")},select(S){p.selected=S,s("selection")},setTip(S){p.tip=S,f.recompute(),s("tip")},setShown(S){Object.assign(p.show,S),s("show")},recompute(){let S=performance.now(),{q:C,qd:E,end:_,torque:v,profile:L,law:T,hasFriction:b,duration:D}=p,{table:F}=f,I=f.start(),{key:O}=f.tip();f.trajectory=p.mode==="motion"?Rp(c,{base:I,from:[...C],to:[..._],duration:D,profile:L,key:O}):p.mode==="free"?Cp(c,{table:F,law:T,hasFriction:b,duration:D,key:O,base:I,q:[...C],qd:[...E],torque:[...v]}):null,M=performance.now()-S,P=void 0,s("trajectory"),s("time")},isStale:()=>P!==void 0,ask(){clearTimeout(P),P=setTimeout(f.recompute,M>gx?160:0)}},[M,P]=[0,void 0];return f.recompute(),f}function fs(n,t){return G("div",{class:"scroll",role:"region",tabIndex:0,"aria-label":n},t)}function Up(n){let{joints:t,freedoms:e,ofBase:i,table:s}=n,r=s.rows.some(b=>b.viscous||b.coulomb.some(Boolean)||b.stribeck),o=s.rows.some(b=>b.spring),a=[{key:"q",sign:"q",unit:"position",isAngle:!0},{key:"qd",sign:"q\u0307",unit:"velocity",isAngle:!0},{key:"qdd",sign:"q\u0308",unit:"acceleration",isAngle:!0},{key:"tau",sign:"\u03C4",unit:"force"},{key:"coriolis",sign:"V",unit:"force"},{key:"gravity",sign:"G",unit:"force"},...o?[{key:"spring",sign:"K",unit:"force"}]:[],...r?[{key:"friction",sign:"F",unit:"force"}]:[]],c=new Map,l=b=>{let D=Jf(b);return c.set(b,D),G("td",{},D)},h=[...new Set(e.map(b=>b.type))],d=a.map(()=>G("th",{class:"unit",scope:"col"})),u=G("table",{class:"numbers wide"},G("caption",{},"State and forces"),G("thead",{},G("tr",{},G("th",{scope:"col"},"joint"),a.map(({sign:b})=>G("th",{scope:"col"},G("i",{},b)))),G("tr",{},G("th",{class:"unit",scope:"col"},""),d)),G("tbody",{},e.map((b,D)=>{let F=D-i,I=G("th",{scope:"row"},G("span",{class:"dot"}),F<0?["base ",un(b.velocity,b.axis)]:b.name);I.style.setProperty("--color",F<0?`var(--axis-${b.axis})`:`var(--joint-${F%8})`);let O=a.map(({key:H})=>H!=="q"?l(`${H}-${D}`):F<0?G("td"):l(`q-${F}`));return G("tr",{},I,O)}))),g=h.length>1?"kg m\xB2, kg m, kg":h[0]==="revolute"?"kg m\xB2":"kg",x=G("table",{class:"numbers matrix"},G("caption",{},"Mass matrix ",G("i",{},"M"),`, ${g}`),G("tbody",{},e.map((b,D)=>G("tr",{},e.map((F,I)=>l(`mass-${D}-${I}`)))))),p=G("span",{},"Tip"),f=(b,D,F)=>G("table",{class:"numbers"},G("caption",{},b," in the world"),G("tbody",{},["x","y","z"].map((I,O)=>G("tr",{},G("th",{scope:"row"},G("i",{},I)),l(D(O)),G("td",{class:"unit"},"m"),G("th",{scope:"row"},["roll","pitch","yaw"][O]),l(F(O)),G("td",{class:"unit angle"}))))),M=f(p,b=>`tip-${b}-3`,b=>`rpy-${b}`),P=i>0?f("Base",b=>`base-${b}`,b=>`baserpy-${b}`):null,S=G("details",{},G("summary",{},"Transform of the tip, 4 \xD7 4"),fs("Transform of the tip",G("table",{class:"numbers matrix"},G("tbody",{},[0,1,2,3].map(b=>G("tr",{},[0,1,2,3].map(D=>l(`T-${b}-${D}`)))))))),C=G("table",{class:"numbers"},G("caption",{},"Energies, J"),G("tbody",{},[["T","kinetic"],["U","potential"],["T + U","total"]].map(([b,D])=>G("tr",{},G("th",{scope:"row"},G("i",{},b)),l(D))))),E=()=>G("table",{class:"numbers"},G("caption",{},"Momentum in the world; ",G("i",{},"L")," about the centre of mass"),G("tbody",{},["x","y","z"].map((b,D)=>G("tr",{},G("th",{scope:"row"},un("p",b)),l(`linear-${D}`),G("td",{class:"unit"},"kg m/s"),G("th",{scope:"row"},un("L",b)),l(`angular-${D}`),G("td",{class:"unit"},"kg m\xB2/s"))))),_=(b,D,F=1)=>jf(c.get(b),D,Jo(D*F));function v(){let{units:b}=n,D=n.evaluated();s.tips.length>1&&(p.textContent=n.tip().name),a.forEach(({key:I,isAngle:O})=>{(I==="q"?t:e).forEach((z,Q)=>_(`${I}-${Q}`,D[I][Q],O?b.factor(z.type):1))});let F=D.mass.map((I,O)=>Math.abs(I[O]));if(e.forEach((I,O)=>e.forEach((H,z)=>{_(`mass-${O}-${z}`,D.mass[O][z]);let Q=Math.abs(D.mass[O][z])/Math.sqrt(F[O]*F[z]);c.get(`mass-${O}-${z}`).parentElement.style.setProperty("--share",Number.isFinite(Q)?Math.min(Q,1).toFixed(3):0)})),D.tip.forEach((I,O)=>I.forEach((H,z)=>_(`T-${O}-${z}`,H))),[0,1,2].forEach(I=>_(`tip-${I}-3`,D.tip[I][3])),dl(D.tip).forEach((I,O)=>_(`rpy-${O}`,I,b.factor("revolute"))),D.base){ji(D.base).forEach((O,H)=>_(`base-${H}`,O));for(let O of["linear","angular"])D.momentum[O].forEach((H,z)=>_(`${O}-${z}`,H));let I=[0,3,6].map(O=>D.base.slice(O,O+3));dl(I).forEach((O,H)=>_(`baserpy-${H}`,O,b.factor("revolute")))}_("kinetic",D.kinetic),_("potential",D.potential),_("total",D.kinetic+D.potential)}function L(){a.forEach(({unit:b},D)=>{d[D].textContent=h.map(F=>n.units[b](F)).join(", ")}),T.querySelectorAll(".angle").forEach(b=>b.textContent=n.units.angleUnit),v()}let T=G("div",{class:"blocks"},fs("Mass matrix",x),P&&fs("Pose of the base",P),fs("Pose of the tip",M),fs("Energies",C),i>0?fs("Momentum",E()):null);return n.on("units",L),n.on("time tip",v),L(),G("section",{class:"panel","aria-label":"Numbers"},fs("State and forces",u),T,S)}var vx="uplot",Sx="u-hz",Mx="u-vt",bx="u-title",wx="u-wrap",Ex="u-under",Tx="u-over",Ax="u-axis",_r="u-off",Rx="u-select",Cx="u-cursor-x",Px="u-cursor-y",Ix="u-cursor-pt",Lx="u-legend",Dx="u-live",Nx="u-inline",Ux="u-series",Fx="u-marker",Fp="u-label",Ox="u-value",na="width",ia="height";var Op="bottom",jr="left",yu="right",Fu="#000",Bp=Fu+"0",vu="mousemove",zp="mousedown",Su="mouseup",kp="mouseenter",Vp="mouseleave",Gp="dblclick",Bx="resize",zx="scroll",Hp="change",El="dppxchange",Ou="--",so=typeof window<"u",Tu=so?document:null,Qr=so?window:null,kx=so?navigator:null,Ae,Sl;function Au(){let n=devicePixelRatio;Ae!=n&&(Ae=n,Sl&&Cu(Hp,Sl,Au),Sl=matchMedia(`(min-resolution: ${Ae-.001}dppx) and (max-resolution: ${Ae+.001}dppx)`),xr(Hp,Sl,Au),Qr.dispatchEvent(new CustomEvent(El)))}function hi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Ru(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ye(n,t,e){n.style[t]=e+"px"}function Pi(n,t,e,i){let s=Tu.createElement(n);return t!=null&&hi(s,t),e?.insertBefore(s,i),s}function Si(n,t){return Pi("div",n,t)}var Wp=new WeakMap;function Ki(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Wp.get(n);r!=o&&(n.style.transform=r,Wp.set(n,r),t<0||e<0||t>i||e>s?hi(n,_r):Ru(n,_r))}var Xp=new WeakMap;function qp(n,t,e){let i=t+e,s=Xp.get(n);i!=s&&(Xp.set(n,i),n.style.background=t,n.style.borderColor=e)}var Yp=new WeakMap;function $p(n,t,e,i){let s=t+""+e,r=Yp.get(n);s!=r&&(Yp.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Bu={passive:!0},Vx={...Bu,capture:!0};function xr(n,t,e,i){t.addEventListener(n,e,i?Vx:Bu)}function Cu(n,t,e,i){t.removeEventListener(n,e,Bu)}so&&Au();function Ii(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ui((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Mm(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var bm=n=>n!=null,wm=n=>n!=null&&n>0,Rl=Mm(bm),Gx=Mm(wm);function Hx(n,t,e,i=0,s=!1){let r=s?Gx:Rl,o=s?wm:bm;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let h=n[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??ze,c??-ze]}function Cl(n,t,e,i){let s=jp(n),r=jp(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?ps:Em,a=s==1?ui:Mi,c=r==1?Mi:ui,l=a(o(xn(n))),h=c(o(xn(t))),d=to(e,l),u=to(e,h);return e==10&&(l<0&&(d=ke(d,-l)),h<0&&(u=ke(u,-h))),i||e==2?(n=d*s,t=u*r):(n=Cm(n,d),t=Pl(t,u)),[n,t]}function zu(n,t,e,i){let s=Cl(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var ku=.1,Zp={mode:3,pad:ku},ra={pad:0,soft:null,mode:0},Wx={min:ra,max:ra};function Tl(n,t,e,i){return Il(e)?Jp(n,t,e):(ra.pad=e,ra.soft=i?0:null,ra.mode=i?3:0,Jp(n,t,Wx))}function we(n,t){return n??t}function Xx(n,t,e){for(t=we(t,0),e=we(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Jp(n,t,e){let i=e.min,s=e.max,r=we(i.pad,0),o=we(s.pad,0),a=we(i.hard,-ze),c=we(s.hard,ze),l=we(i.soft,ze),h=we(s.soft,-ze),d=we(i.mode,0),u=we(s.mode,0),m=t-n,g=ps(m),x=qn(xn(n),xn(t)),p=ps(x),f=xn(p-g);(m<1e-24||f>10)&&(m=0,(n==0||t==0)&&(m=1e-24,d==2&&l!=ze&&(r=0),u==2&&h!=-ze&&(o=0)));let M=m||x||1e3,P=ps(M),S=to(10,ui(P)),C=M*(m==0?n==0?.1:1:r),E=ke(Cm(n-C,S/10),24),_=n>=l&&(d==1||d==3&&E<=l||d==2&&E>=l)?l:ze,v=qn(a,E<_&&n>=_?_:Li(_,E)),L=M*(m==0?t==0?.1:1:o),T=ke(Pl(t+L,S/10),24),b=t<=h&&(u==1||u==3&&T>=h||u==2&&T<=h)?h:-ze,D=Li(c,T>b&&t<=b?b:qn(b,T));return v==D&&v==0&&(D=100),[v,D]}var qx=new Intl.NumberFormat(so?kx.language:"en-US"),Vu=n=>qx.format(n),di=Math,wl=di.PI,xn=di.abs,ui=di.floor,_n=di.round,Mi=di.ceil,Li=di.min,qn=di.max,to=di.pow,jp=di.sign,ps=di.log10,Em=di.log2,Yx=(n,t=1)=>di.sinh(n)*t,Mu=(n,t=1)=>di.asinh(n/t),ze=1/0;function Kp(n){return(ps((n^n>>31)-(n>>31))|0)+1}function Pu(n,t,e){return Li(qn(n,t),e)}function Tm(n){return typeof n=="function"}function ye(n){return Tm(n)?n:()=>n}var $x=()=>{},Am=n=>n,Rm=(n,t)=>t,Zx=n=>null,Qp=n=>!0,tm=(n,t)=>n==t,Jx=/\.\d*?(?=9{6,}|0{6,})/gm,yr=n=>{if(Im(n)||ks.has(n))return n;let t=`${n}`,e=t.match(Jx);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${yr(s)}e${r}`}return ke(n,i)};function mr(n,t){return yr(ke(yr(n/t))*t)}function Pl(n,t){return yr(Mi(yr(n/t))*t)}function Cm(n,t){return yr(ui(yr(n/t))*t)}function ke(n,t=0){if(Im(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return _n(i)/e}var ks=new Map;function Pm(n){return((""+n).split(".")[1]||"").length}function aa(n,t,e,i){let s=[],r=i.map(Pm);for(let o=t;o<e;o++){let a=xn(o),c=ke(to(n,o),a);for(let l=0;l<i.length;l++){let h=n==10?+`${i[l]}e${o}`:i[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),u=n==10?h:ke(h,d);s.push(u),ks.set(u,d)}}return s}var oa={},Gu=[],eo=[null,null],zs=Array.isArray,Im=Number.isInteger,jx=n=>n===void 0;function em(n){return typeof n=="string"}function Il(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Kx(n){return n!=null&&typeof n=="object"}var Qx=Object.getPrototypeOf(Uint8Array),Lm="__proto__";function no(n,t=Il){let e;if(zs(n)){let i=n.find(s=>s!=null);if(zs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=no(n[s],t)}else e=n.slice()}else if(n instanceof Qx)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Lm&&(e[i]=no(n[i],t))}else e=n;return e}function dn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Lm&&(Il(n[s])?dn(n[s],no(i[s])):n[s]=no(i[s]))}return n}var ty=0,ey=1,ny=2;function iy(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function sy(n,t){if(ay(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return ly(o[0])||(o=oy(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],d=Array(s).fill(void 0),u=t?t[o][l]:ey,m=[];for(let g=0;g<h.length;g++){let x=h[g],p=r.get(c[g]);x===null?u!=ty&&(d[p]=x,u==ny&&m.push(p)):d[p]=x}iy(d,m,s),i.push(d)}}return i}var ry=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function oy(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function ay(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function ly(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=qn(1,ui((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Dm=["January","February","March","April","May","June","July","August","September","October","November","December"],Nm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Um(n){return n.slice(0,3)}var cy=Nm.map(Um),hy=Dm.map(Um),uy={MMMM:Dm,MMM:hy,WWWW:Nm,WWW:cy};function ea(n){return(n<10?"0":"")+n}function dy(n){return(n<10?"00":n<100?"0":"")+n}var fy={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ea(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ea(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ea(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ea(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ea(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>dy(n.getMilliseconds())};function Hu(n,t){t=t||uy;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?fy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var py=new Intl.DateTimeFormat().resolvedOptions().timeZone;function my(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==py?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Fm=n=>n%1==0,Al=[1,2,2.5,5],gy=aa(10,-32,0,Al),Om=aa(10,0,32,Al),_y=Om.filter(Fm),gr=gy.concat(Om),Wu=`
`,Bm="{YYYY}",nm=Wu+Bm,zm="{M}/{D}",sa=Wu+zm,Ml=sa+"/{YY}",km="{aa}",xy="{h}:{mm}",Kr=xy+km,im=Wu+Kr,sm=":{ss}",Pe=null;function Vm(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?aa(10,0,3,Al).filter(Fm):aa(10,-3,0,Al)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Bm,Pe,Pe,Pe,Pe,Pe,Pe,1],[s*28,"{MMM}",nm,Pe,Pe,Pe,Pe,Pe,1],[s,zm,nm,Pe,Pe,Pe,Pe,Pe,1],[i,"{h}"+km,Ml,Pe,sa,Pe,Pe,Pe,1],[e,Kr,Ml,Pe,sa,Pe,Pe,Pe,1],[t,sm,Ml+" "+Kr,Pe,sa+" "+Kr,Pe,im,Pe,1],[n,sm+".{fff}",Ml+" "+Kr,Pe,sa+" "+Kr,Pe,im,Pe,1]];function h(d){return(u,m,g,x,p,f)=>{let M=[],P=p>=o,S=p>=r&&p<o,C=d(g),E=ke(C*n,3),_=bu(C.getFullYear(),P?0:C.getMonth(),S||P?1:C.getDate()),v=ke(_*n,3);if(S||P){let L=S?p/r:0,T=P?p/o:0,b=E==v?E:ke(bu(_.getFullYear()+T,_.getMonth()+L,1)*n,3),D=new Date(_n(b/n)),F=D.getFullYear(),I=D.getMonth();for(let O=0;b<=x;O++){let H=bu(F+T*O,I+L*O,1),z=H-d(ke(H*n,3));b=ke((+H+z)*n,3),b<=x&&M.push(b)}}else{let L=p>=s?s:p,T=ui(g)-ui(E),b=v+T+Pl(E-v,L);M.push(b);let D=d(b),F=D.getHours()+D.getMinutes()/e+D.getSeconds()/i,I=p/i,O=u.axes[m]._space,H=f/O;for(;b=ke(b+p,n==1?0:3),!(b>x);)if(I>1){let z=ui(ke(F+I,6))%24,Z=d(b).getHours()-z;Z>1&&(Z=-1),b-=Z*i,F=(F+I)%24;let nt=M[M.length-1];ke((b-nt)/p,3)*H>=.7&&M.push(b)}else M.push(b)}return M}}return[c,l,h]}var[yy,vy,Sy]=Vm(1),[My,by,wy]=Vm(.001);aa(2,-53,53,[1]);function rm(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function om(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],c,l,h,d,u,m;return i.map(g=>{let x=n(g),p=x.getFullYear(),f=x.getMonth(),M=x.getDate(),P=x.getHours(),S=x.getMinutes(),C=x.getSeconds(),E=p!=c&&a[2]||f!=l&&a[3]||M!=h&&a[4]||P!=d&&a[5]||S!=u&&a[6]||C!=m&&a[7]||a[1];return c=p,l=f,h=M,d=P,u=S,m=C,E(x)})}}function Ey(n,t){let e=Hu(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function bu(n,t,e){return new Date(n,t,e)}function am(n,t){return t(n)}var Ty="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function lm(n,t){return(e,i,s,r)=>r==null?Ou:t(n(i))}function Ay(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function Ry(n,t){return n.series[t].fill(n,t)}var Cy={show:!0,live:!0,isolate:!1,mount:$x,markers:{show:!0,width:2,stroke:Ay,fill:Ry,dash:"solid"},idx:null,idxs:null,values:[]};function Py(n,t){let e=n.cursor.points,i=Si(),s=e.size(n,t);Ye(i,na,s),Ye(i,ia,s);let r=s/-2;Ye(i,"marginLeft",r),Ye(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ye(i,"borderWidth",o),i}function Iy(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Ly(n,t){let e=n.series[t].points;return e._stroke||e._fill}function Dy(n,t){return n.series[t].points.size}var wu=[0,0];function Ny(n,t,e){return wu[0]=t,wu[1]=e,wu}function bl(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Eu(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var Uy={show:!0,x:!0,y:!0,lock:!1,move:Ny,points:{one:!1,show:Py,size:Dy,width:0,stroke:Ly,fill:Iy},bind:{mousedown:bl,mouseup:bl,click:bl,dblclick:bl,mousemove:Eu,mouseleave:Eu,mouseenter:Eu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Gm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xu=dn({},Gm,{filter:Rm}),Hm=dn({},Xu,{size:10}),Wm=dn({},Gm,{show:!1}),qu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Xm="bold "+qu,qm=1.5,cm={show:!0,scale:"x",stroke:Fu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xm,side:2,grid:Xu,ticks:Hm,border:Wm,font:qu,lineGap:qm,rotate:0},Fy="Value",Oy="Time",hm={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function By(n,t,e,i,s){return t.map(r=>r==null?"":Vu(r))}function zy(n,t,e,i,s,r,o){let a=[],c=ks.get(s)||0;e=o?e:ke(Pl(e,s),c);for(let l=e;l<=i;l=ke(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Iu(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?ps:Em,h=ui(l(e));s=to(c,h),c==10&&(s=gr[Ii(s,gr)]);let d=e,u=s*c;c==10&&(u=gr[Ii(u,gr)]);do a.push(d),d=d+s,c==10&&!ks.has(d)&&(d=ke(d,ks.get(s))),d>=u&&(s=d,u=s*c,c==10&&(u=gr[Ii(u,gr)]));while(d<=i);return a}function ky(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?Iu(n,t,qn(c,e),i,s):[c],h=i>=0&&e<=0?[0]:[];return(e<-c?Iu(n,t,qn(c,-i),-e,s):[c]).reverse().map(u=>-u).concat(h,l)}var Ym=/./,Vy=/[12357]/,Gy=/[125]/,um=/1/,Lu=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Hy(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,h=c(10,o),d=c(9,o)-h>=l?Ym:c(7,o)-h>=l?Vy:c(5,o)-h>=l?Gy:um;if(d==um){let u=xn(c(1,o)-h);if(u<l)return Lu(t.slice().reverse(),a.distr,d,Mi(l/u)).reverse()}return Lu(t,a.distr,d,1)}function Wy(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=xn(c(1,o)-c(2,o));return l<a?Lu(t.slice().reverse(),3,Ym,Mi(a/l)).reverse():t}function Xy(n,t,e,i){return i==null?Ou:t==null?"":Vu(t)}var dm={show:!0,scale:"y",stroke:Fu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Xm,side:3,grid:Xu,ticks:Hm,border:Wm,font:qu,lineGap:qm,rotate:0};function qy(n,t){let e=3+(n||1)*2;return ke(e*t,3)}function Yy(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=xn(o-r),c=n.series[t],l=a/(c.points.space*Ae);return i[1]-i[0]<=l}var fm={scale:null,auto:!0,sorted:0,min:ze,max:-ze},$m=(n,t,e,i,s)=>s,pm={show:!0,auto:!0,sorted:0,gaps:$m,alpha:1,facets:[dn({},fm,{scale:"x"}),dn({},fm,{scale:"y"})]},mm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$m,alpha:1,points:{show:Yy,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function $y(n,t,e,i,s){return e/10}var Zm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Zy=dn({},Zm,{time:!1,ori:1}),gm={};function Jm(n,t){let e=gm[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,c,l)}},n!=null&&(gm[n]=e)),e}var io=1,Du=2;function vr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,m=a.top,g=a.width,x=a.height,p=n.valToPosH,f=n.valToPosV;return h.ori==0?e(s,c,l,h,d,p,f,u,m,g,x,Dl,ro,Ul,Km,tg):e(s,c,l,h,d,f,p,m,u,x,g,Nl,oo,Zu,Qm,eg)}function Yu(n,t){let e=0,i=0,s=we(n.bands,Gu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Jy(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ms(n,t,e,i,s,r){return vr(n,t,(o,a,c,l,h,d,u,m,g,x,p)=>{let f=o.pxRound,M=l.dir*(l.ori==0?1:-1),P=l.ori==0?ro:oo,S,C;M==1?(S=e,C=i):(S=i,C=e);let E=f(d(a[S],l,x,m)),_=f(u(c[S],h,p,g)),v=f(d(a[C],l,x,m)),L=f(u(r==1?h.max:h.min,h,p,g)),T=new Path2D(s);return P(T,v,L),P(T,E,L),P(T,E,_),T})}function Ll(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Ul:Zu,c=e;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let m=u[0]-c;m>0&&a(o,c,i,m,i+r),c=u[1]}}let l=e+s-c,h=10;l>0&&a(o,c,i-h/2,l,i+r+h)}return o}function jy(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function $u(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let d=l,u=l;if(s==1)for(;++l<=i&&t[l]===null;)u=l;else for(;--l>=e&&t[l]===null;)u=l;let m=r(n[d]),g=u==d?m:r(n[u]),x=d-s;m=o<=0&&x>=0&&x<c?r(n[x]):m;let f=u+s;g=o>=0&&f>=0&&f<c?r(n[f]):g,g>=m&&a.push([m,g])}return a}function _m(n){return n==0?Am:n==1?_n:t=>mr(t,n)}function jm(n){let t=n==0?Dl:Nl,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?i(s,r,o,a,c):(l=Li(l,a/2,c/2),h=Li(h,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,h),e(s,r,o+c,r,o,h),e(s,r,o,r+a,o,l),s.closePath())}}var Dl=(n,t,e)=>{n.moveTo(t,e)},Nl=(n,t,e)=>{n.moveTo(e,t)},ro=(n,t,e)=>{n.lineTo(t,e)},oo=(n,t,e)=>{n.lineTo(e,t)},Ul=jm(0),Zu=jm(1),Km=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Qm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},tg=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},eg=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function ng(n){return(t,e,i,s,r)=>vr(t,e,(o,a,c,l,h,d,u,m,g,x,p)=>{let{pxRound:f,points:M}=o,P,S;l.ori==0?(P=Dl,S=Km):(P=Nl,S=Qm);let C=ke(M.width*Ae,3),E=(M.size-M.width)/2*Ae,_=ke(E*2,3),v=new Path2D,L=new Path2D,{left:T,top:b,width:D,height:F}=t.bbox;Ul(L,T-_,b-_,D+_*2,F+_*2);let I=O=>{if(c[O]!=null){let H=f(d(a[O],l,x,m)),z=f(u(c[O],h,p,g));P(v,H+E,z),S(v,H,z,E,0,wl*2)}};if(r)r.forEach(I);else for(let O=i;O<=s;O++)I(O);return{stroke:C>0?v:null,fill:v,clip:L,flags:io|Du}})}function ig(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var Ky=ig(ro),Qy=ig(oo);function sg(n){let t=we(n?.alignGaps,0);return(e,i,s,r)=>vr(e,i,(o,a,c,l,h,d,u,m,g,x,p)=>{[s,r]=Rl(c,s,r);let f=o.pxRound,M=F=>f(d(F,l,x,m)),P=F=>f(u(F,h,p,g)),S,C;l.ori==0?(S=ro,C=Ky):(S=oo,C=Qy);let E=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},v=_.stroke,L=!1;if(r-s>=x*4){let F=ht=>e.posToVal(ht,l.key,!0),I=null,O=null,H,z,Q,Y=M(a[E==1?s:r]),Z=M(a[s]),nt=M(a[r]),lt=F(E==1?Z+1:nt-1);for(let ht=E==1?s:r;ht>=s&&ht<=r;ht+=E){let tt=a[ht],_t=(E==1?tt<lt:tt>lt)?Y:M(tt),ot=c[ht];_t==Y?ot!=null?(z=ot,I==null?(S(v,_t,P(z)),H=I=O=z):z<I?I=z:z>O&&(O=z)):ot===null&&(L=!0):(I!=null&&C(v,Y,P(I),P(O),P(H),P(z)),ot!=null?(z=ot,S(v,_t,P(z)),I=O=H=z):(I=O=null,ot===null&&(L=!0)),Y=_t,lt=F(Y+E))}I!=null&&I!=O&&Q!=Y&&C(v,Y,P(I),P(O),P(H),P(z))}else for(let F=E==1?s:r;F>=s&&F<=r;F+=E){let I=c[F];I===null?L=!0:I!=null&&S(v,M(a[F]),P(I))}let[b,D]=Yu(e,i);if(o.fill!=null||b!=0){let F=_.fill=new Path2D(v),I=o.fillTo(e,i,o.min,o.max,b),O=P(I),H=M(a[s]),z=M(a[r]);E==-1&&([z,H]=[H,z]),S(F,z,O),S(F,H,O)}if(!o.spanGaps){let F=[];L&&F.push(...$u(a,c,s,r,E,M,t)),_.gaps=F=o.gaps(e,i,s,r,F),_.clip=Ll(F,l.ori,m,g,x,p)}return D!=0&&(_.band=D==2?[ms(e,i,s,r,v,-1),ms(e,i,s,r,v,1)]:ms(e,i,s,r,v,D)),_})}function tv(n){let t=we(n.align,1),e=we(n.ascDesc,!1),i=we(n.alignGaps,0),s=we(n.extend,!1);return(r,o,a,c)=>vr(r,o,(l,h,d,u,m,g,x,p,f,M,P)=>{[a,c]=Rl(d,a,c);let S=l.pxRound,{left:C,width:E}=r.bbox,_=Z=>S(g(Z,u,M,p)),v=Z=>S(x(Z,m,P,f)),L=u.ori==0?ro:oo,T={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},b=T.stroke,D=u.dir*(u.ori==0?1:-1),F=v(d[D==1?a:c]),I=_(h[D==1?a:c]),O=I,H=I;s&&t==-1&&(H=C,L(b,H,F)),L(b,I,F);for(let Z=D==1?a:c;Z>=a&&Z<=c;Z+=D){let nt=d[Z];if(nt==null)continue;let lt=_(h[Z]),ht=v(nt);t==1?L(b,lt,F):L(b,O,ht),L(b,lt,ht),F=ht,O=lt}let z=O;s&&t==1&&(z=C+E,L(b,z,F));let[Q,Y]=Yu(r,o);if(l.fill!=null||Q!=0){let Z=T.fill=new Path2D(b),nt=l.fillTo(r,o,l.min,l.max,Q),lt=v(nt);L(Z,z,lt),L(Z,H,lt)}if(!l.spanGaps){let Z=[];Z.push(...$u(h,d,a,c,D,_,i));let nt=l.width*Ae/2,lt=e||t==1?nt:-nt,ht=e||t==-1?-nt:nt;Z.forEach(tt=>{tt[0]+=lt,tt[1]+=ht}),T.gaps=Z=l.gaps(r,o,a,c,Z),T.clip=Ll(Z,u.ori,p,f,M,P)}return Y!=0&&(T.band=Y==2?[ms(r,o,a,c,b,-1),ms(r,o,a,c,b,1)]:ms(r,o,a,c,b,Y)),T})}function xm(n,t,e,i,s,r,o=ze){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let h=xn(n[c]-n[a]);h<l&&(l=h,o=xn(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function ev(n){n=n||oa;let t=we(n.size,[.6,ze,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=we(t[1],ze),c=we(t[2],1),l=we(n.disp,oa),h=we(n.each,m=>{}),{fill:d,stroke:u}=l;return(m,g,x,p)=>vr(m,g,(f,M,P,S,C,E,_,v,L,T,b)=>{let D=f.pxRound,F=e,I=i*Ae,O=a*Ae,H=c*Ae,z,Q;S.ori==0?[z,Q]=r(m,g):[Q,z]=r(m,g);let Y=S.dir*(S.ori==0?1:-1),Z=S.ori==0?Ul:Zu,nt=S.ori==0?h:(Ct,jt,le,wt,Be,Wt,Zt)=>{h(Ct,jt,le,Be,wt,Zt,Wt)},lt=we(m.bands,Gu).find(Ct=>Ct.series[0]==g),ht=lt!=null?lt.dir:0,tt=f.fillTo(m,g,f.min,f.max,ht),mt=D(_(tt,C,b,L)),_t,ot,dt,Nt=T,$t=D(f.width*Ae),Ot=!1,se=null,ae=null,Xt=null,Se=null;d!=null&&($t==0||u!=null)&&(Ot=!0,se=d.values(m,g,x,p),ae=new Map,new Set(se).forEach(Ct=>{Ct!=null&&ae.set(Ct,new Path2D)}),$t>0&&(Xt=u.values(m,g,x,p),Se=new Map,new Set(Xt).forEach(Ct=>{Ct!=null&&Se.set(Ct,new Path2D)})));let{x0:Ce,size:je}=l;if(Ce!=null&&je!=null){F=1,M=Ce.values(m,g,x,p),Ce.unit==2&&(M=M.map(le=>m.posToVal(v+le*T,S.key,!0)));let Ct=je.values(m,g,x,p);je.unit==2?ot=Ct[0]*T:ot=E(Ct[0],S,T,v)-E(0,S,T,v),Nt=xm(M,P,E,S,T,v,Nt),dt=Nt-ot+I}else Nt=xm(M,P,E,S,T,v,Nt),dt=Nt*o+I,ot=Nt-dt;dt<1&&(dt=0),$t>=ot/2&&($t=0),dt<5&&(D=Am);let Ee=dt>0,Mn=Nt-dt-(Ee?$t:0);ot=D(Pu(Mn,H,O)),_t=(F==0?ot/2:F==Y?0:ot)-F*Y*((F==0?I/2:0)+(Ee?$t/2:0));let Me={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},mn=Ot?null:new Path2D,Ke=null;if(lt!=null)Ke=m.data[lt.series[1]];else{let{y0:Ct,y1:jt}=l;Ct!=null&&jt!=null&&(P=jt.values(m,g,x,p),Ke=Ct.values(m,g,x,p))}let on=z*ot,V=Q*ot;for(let Ct=Y==1?x:p;Ct>=x&&Ct<=p;Ct+=Y){let jt=P[Ct];if(jt==null)continue;if(Ke!=null){let $=Ke[Ct]??0;if(jt-$==0)continue;mt=_($,C,b,L)}let le=S.distr!=2||l!=null?M[Ct]:Ct,wt=E(le,S,T,v),Be=_(we(jt,tt),C,b,L),Wt=D(wt-_t),Zt=D(qn(Be,mt)),N=D(Li(Be,mt)),w=Zt-N;if(jt!=null){let $=jt<0?V:on,pt=jt<0?on:V;Ot?($t>0&&Xt[Ct]!=null&&Z(Se.get(Xt[Ct]),Wt,N+ui($t/2),ot,qn(0,w-$t),$,pt),se[Ct]!=null&&Z(ae.get(se[Ct]),Wt,N+ui($t/2),ot,qn(0,w-$t),$,pt)):Z(mn,Wt,N+ui($t/2),ot,qn(0,w-$t),$,pt),nt(m,g,Ct,Wt-$t/2,N,ot+$t,w)}}return $t>0?Me.stroke=Ot?Se:mn:Ot||(Me._fill=f.width==0?f._fill:f._stroke??f._fill,Me.width=0),Me.fill=Ot?ae:mn,Me})}function nv(n,t){let e=we(t?.alignGaps,0);return(i,s,r,o)=>vr(i,s,(a,c,l,h,d,u,m,g,x,p,f)=>{[r,o]=Rl(l,r,o);let M=a.pxRound,P=z=>M(u(z,h,p,g)),S=z=>M(m(z,d,f,x)),C,E,_;h.ori==0?(C=Dl,_=ro,E=tg):(C=Nl,_=oo,E=eg);let v=h.dir*(h.ori==0?1:-1),L=P(c[v==1?r:o]),T=L,b=[],D=[];for(let z=v==1?r:o;z>=r&&z<=o;z+=v)if(l[z]!=null){let Y=c[z],Z=P(Y);b.push(T=Z),D.push(S(l[z]))}let F={stroke:n(b,D,C,_,E,M),fill:null,clip:null,band:null,gaps:null,flags:io},I=F.stroke,[O,H]=Yu(i,s);if(a.fill!=null||O!=0){let z=F.fill=new Path2D(I),Q=a.fillTo(i,s,a.min,a.max,O),Y=S(Q);_(z,T,Y),_(z,L,Y)}if(!a.spanGaps){let z=[];z.push(...$u(c,l,r,o,v,P,e)),F.gaps=z=a.gaps(i,s,r,o,z),F.clip=Ll(z,h.ori,g,x,p,f)}return H!=0&&(F.band=H==2?[ms(i,s,r,o,I,-1),ms(i,s,r,o,I,1)]:ms(i,s,r,o,I,H)),F})}function iv(n){return nv(sv,n)}function sv(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=n[u+1]-n[u],l[u]=h[u]/d[u];c[0]=l[0];for(let u=1;u<o-1;u++)l[u]===0||l[u-1]===0||l[u-1]>0!=l[u]>0?c[u]=0:(c[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/l[u-1]+(d[u]+2*d[u-1])/l[u]),isFinite(c[u])||(c[u]=0));c[o-1]=l[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,t[u]+c[u]*d[u]/3,n[u+1]-d[u]/3,t[u+1]-c[u+1]*d[u]/3,n[u+1],t[u+1])}return a}var Nu=new Set;function ym(){for(let n of Nu)n.syncRect(!0)}so&&(xr(Bx,Qr,ym),xr(zx,Qr,ym,!0),xr(El,Qr,()=>{Pn.pxRatio=Ae}));var rv=sg(),ov=ng();function vm(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Uu(r,o,t,e))}function av(n,t){return n.map((e,i)=>i==0?{}:dn({},t,e))}function Uu(n,t,e,i){return dn({},t==0?e:i,n)}function rg(n,t,e){return t==null?eo:[t,e]}var lv=rg;function cv(n,t,e){return t==null?eo:Tl(t,e,ku,!0)}function og(n,t,e,i){return t==null?eo:Cl(t,e,n.scales[i].log,!1)}var hv=og;function ag(n,t,e,i){return t==null?eo:zu(t,e,n.scales[i].log,!1)}var uv=ag;function dv(n,t,e,i,s){let r=qn(Kp(n),Kp(t)),o=t-n,a=Ii(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?ks.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Sm(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=_n((e=+s)*Ae))+"px"),[n,t,e]}function fv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=ke(t[2]*Ae,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Pn(n,t,e){let i={mode:we(n.mode,1)},s=i.mode;function r(y,A,U,B){let X=A.valToPct(y);return B+U*(A.dir==-1?1-X:X)}function o(y,A,U,B){let X=A.valToPct(y);return B+U*(A.dir==-1?X:1-X)}function a(y,A,U,B){return A.ori==0?r(y,A,U,B):o(y,A,U,B)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=Si(vx);if(n.id!=null&&(l.id=n.id),hi(l,n.class),n.title){let y=Si(bx,l);y.textContent=n.title}let h=Pi("canvas"),d=i.ctx=h.getContext("2d"),u=Si(wx,l);xr("click",u,y=>{y.target===g&&(He!=Gr||Ze!=Hr)&&Rn.click(i,y)},!0);let m=i.under=Si(Ex,u);u.appendChild(h);let g=i.over=Si(Tx,u);n=no(n);let x=+we(n.pxAlign,1),p=_m(x);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let f=n.ms||.001,M=i.series=s==1?vm(n.series||[],hm,mm,!1):av(n.series||[null],pm),P=i.axes=vm(n.axes||[],cm,dm,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(y=>{y.fill=ye(y.fill||null),y.dir=we(y.dir,-1)});let E=s==2?M[1].facets[0].scale:M[0].scale,_={axes:us,series:me},v=(n.drawOrder||["axes","series"]).map(y=>_[y]);function L(y){let A=y.distr==3?U=>ps(U>0?U:y.clamp(i,U,y.min,y.max,y.key)):y.distr==4?U=>Mu(U,y.asinh):y.distr==100?U=>y.fwd(U):U=>U;return U=>{let B=A(U),{_min:X,_max:K}=y,ut=K-X;return(B-X)/ut}}function T(y){let A=S[y];if(A==null){let U=(n.scales||oa)[y]||oa;if(U.from!=null){T(U.from);let B=dn({},S[U.from],U,{key:y});B.valToPct=L(B),S[y]=B}else{A=S[y]=dn({},y==E?Zm:Zy,U),A.key=y;let B=A.time,X=A.range,K=zs(X);if((y!=E||s==2&&!B)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Zp:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Zp:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&Il(X))){let ut=X;X=(gt,Mt,Ut)=>Mt==null?eo:Tl(Mt,Ut,ut)}A.range=ye(X||(B?lv:y==E?A.distr==3?hv:A.distr==4?uv:rg:A.distr==3?og:A.distr==4?ag:cv)),A.auto=ye(K?!1:A.auto),A.clamp=ye(A.clamp||$y),A._min=A._max=null,A.valToPct=L(A)}}}T("x"),T("y"),s==1&&M.forEach(y=>{T(y.scale)}),P.forEach(y=>{T(y.scale)});for(let y in n.scales)T(y);let b=S[E],D=b.distr,F,I;b.ori==0?(hi(l,Sx),F=r,I=o):(hi(l,Mx),F=o,I=r);let O={};for(let y in S){let A=S[y];(A.min!=null||A.max!=null)&&(O[y]={min:A.min,max:A.max},A.min=A.max=null)}let H=n.tzDate||(y=>new Date(_n(y/f))),z=n.fmtDate||Hu,Q=f==1?Sy(H):wy(H),Y=om(H,rm(f==1?vy:by,z)),Z=lm(H,am(Ty,z)),nt=[],lt=i.legend=dn({},Cy,n.legend),ht=i.cursor=dn({},Uy,{drag:{y:s==2}},n.cursor),tt=lt.show,mt=ht.show,_t=lt.markers;lt.idxs=nt,_t.width=ye(_t.width),_t.dash=ye(_t.dash),_t.stroke=ye(_t.stroke),_t.fill=ye(_t.fill);let ot,dt,Nt,$t=[],Ot=[],se,ae=!1,Xt={};if(lt.live){let y=M[1]?M[1].values:null;ae=y!=null,se=ae?y(i,1,0):{_:0};for(let A in se)Xt[A]=Ou}if(tt)if(ot=Pi("table",Lx,l),Nt=Pi("tbody",null,ot),lt.mount(i,ot),ae){dt=Pi("thead",null,ot,Nt);let y=Pi("tr",null,dt);Pi("th",null,y);for(var Se in se)Pi("th",Fp,y).textContent=Se}else hi(ot,Nx),lt.live&&hi(ot,Dx);let Ce={show:!0},je={show:!1};function Ee(y,A){if(A==0&&(ae||!lt.live||s==2))return eo;let U=[],B=Pi("tr",Ux,Nt,Nt.childNodes[A]);hi(B,y.class),y.show||hi(B,_r);let X=Pi("th",null,B);if(_t.show){let gt=Si(Fx,X);if(A>0){let Mt=_t.width(i,A);Mt&&(gt.style.border=Mt+"px "+_t.dash(i,A)+" "+_t.stroke(i,A)),gt.style.background=_t.fill(i,A)}}let K=Si(Fp,X);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,A>0&&(_t.show||(K.style.color=y.width>0?_t.stroke(i,A):_t.fill(i,A)),Me("click",X,gt=>{if(ht._lock)return;te(gt);let Mt=M.indexOf(y);if((gt.ctrlKey||gt.metaKey)!=lt.isolate){let Ut=M.some((Ft,zt)=>zt>0&&zt!=Mt&&Ft.show);M.forEach((Ft,zt)=>{zt>0&&Yi(zt,Ut?zt==Mt?Ce:je:Ce,!0,hn.setSeries)})}else Yi(Mt,{show:!y.show},!0,hn.setSeries)},!1),ee&&Me(kp,X,gt=>{ht._lock||(te(gt),Yi(M.indexOf(y),Xr,!0,hn.setSeries))},!1));for(var ut in se){let gt=Pi("td",Ox,B);gt.textContent="--",U.push(gt)}return[B,U]}let Mn=new Map;function Me(y,A,U,B=!0){let X=Mn.get(A)||{},K=ht.bind[y](i,A,U,B);K&&(xr(y,A,X[y]=K),Mn.set(A,X))}function mn(y,A,U){let B=Mn.get(A)||{};for(let X in B)(y==null||X==y)&&(Cu(X,A,B[X]),delete B[X]);y==null&&Mn.delete(A)}let Ke=0,on=0,V=0,Ct=0,jt=0,le=0,wt=jt,Be=le,Wt=V,Zt=Ct,N=0,w=0,$=0,pt=0;i.bbox={};let ct=!1,vt=!1,St=!1,it=!1,rt=!1,xt=!1;function k(y,A,U){(U||y!=i.width||A!=i.height)&&at(y,A),de(!1),St=!0,vt=!0,Un()}function at(y,A){i.width=Ke=V=y,i.height=on=Ct=A,jt=le=0,bt(),qt();let U=i.bbox;N=U.left=mr(jt*Ae,.5),w=U.top=mr(le*Ae,.5),$=U.width=mr(V*Ae,.5),pt=U.height=mr(Ct*Ae,.5)}let st=3;function Et(){let y=!1,A=0;for(;!y;){A++;let U=zr(A),B=qi(A);y=A==st||U&&B,y||(at(i.width,i.height),vt=!0)}}function yt({width:y,height:A}){k(y,A)}i.setSize=yt;function bt(){let y=!1,A=!1,U=!1,B=!1;P.forEach((X,K)=>{if(X.show&&X._show){let{side:ut,_size:gt}=X,Mt=ut%2,Ut=X.label!=null?X.labelSize:0,Ft=gt+Ut;Ft>0&&(Mt?(V-=Ft,ut==3?(jt+=Ft,B=!0):U=!0):(Ct-=Ft,ut==0?(le+=Ft,y=!0):A=!0))}}),Wi[0]=y,Wi[1]=U,Wi[2]=A,Wi[3]=B,V-=Ti[1]+Ti[3],jt+=Ti[3],Ct-=Ti[2]+Ti[0],le+=Ti[0]}function qt(){let y=jt+V,A=le+Ct,U=jt,B=le;function X(K,ut){switch(K){case 1:return y+=ut,y-ut;case 2:return A+=ut,A-ut;case 3:return U-=ut,U+ut;case 0:return B-=ut,B+ut}}P.forEach((K,ut)=>{if(K.show&&K._show){let gt=K.side;K._pos=X(gt,K._size),K.label!=null&&(K._lpos=X(gt,K.labelSize))}})}if(ht.dataIdx==null){let y=ht.hover,A=y.skip=new Set(y.skip??[]);A.add(void 0);let U=y.prox=ye(y.prox),B=y.bias??=0;ht.dataIdx=(X,K,ut,gt)=>{if(K==0)return ut;let Mt=ut,Ut=U(X,K,ut,gt)??ze,Ft=Ut>=0&&Ut<ze,zt=b.ori==0?V:Ct,oe=ht.left,Te=t[0],be=t[K];if(A.has(be[ut])){Mt=null;let ge=null,Qt=null,Yt;if(B==0||B==-1)for(Yt=ut;ge==null&&Yt-- >0;)A.has(be[Yt])||(ge=Yt);if(B==0||B==1)for(Yt=ut;Qt==null&&Yt++<be.length;)A.has(be[Yt])||(Qt=Yt);if(ge!=null||Qt!=null)if(Ft){let Xe=ge==null?-1/0:F(Te[ge],b,zt,0),en=Qt==null?1/0:F(Te[Qt],b,zt,0),Tn=oe-Xe,Oe=en-oe;Tn<=Oe?Tn<=Ut&&(Mt=ge):Oe<=Ut&&(Mt=Qt)}else Mt=Qt==null?ge:ge==null?Qt:ut-ge<=Qt-ut?ge:Qt}else Ft&&xn(oe-F(Te[ut],b,zt,0))>Ut&&(Mt=null);return Mt}}let te=y=>{ht.event=y};ht.idxs=nt,ht._lock=!1;let ft=ht.points;ft.show=ye(ft.show),ft.size=ye(ft.size),ft.stroke=ye(ft.stroke),ft.width=ye(ft.width),ft.fill=ye(ft.fill);let kt=i.focus=dn({},n.focus||{alpha:.3},ht.focus),ee=kt.prox>=0,Rt=ee&&ft.one,ue=[],Ge=[],Vn=[];function Go(y,A){let U=ft.show(i,A);if(U instanceof HTMLElement)return hi(U,Ix),hi(U,y.class),Ki(U,-10,-10,V,Ct),g.insertBefore(U,ue[A]),U}function Fr(y,A){if(s==1||A>0){let U=s==1&&S[y.scale].time,B=y.value;y.value=U?em(B)?lm(H,am(B,z)):B||Z:B||Xy,y.label=y.label||(U?Oy:Fy)}if(Rt||A>0){y.width=y.width==null?1:y.width,y.paths=y.paths||rv||Zx,y.fillTo=ye(y.fillTo||Jy),y.pxAlign=+we(y.pxAlign,x),y.pxRound=_m(y.pxAlign),y.stroke=ye(y.stroke||null),y.fill=ye(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let U=qy(qn(1,y.width),1),B=y.points=dn({},{size:U,width:qn(1,U*.2),stroke:y.stroke,space:U*2,paths:ov,_stroke:null,_fill:null},y.points);B.show=ye(B.show),B.filter=ye(B.filter),B.fill=ye(B.fill),B.stroke=ye(B.stroke),B.paths=ye(B.paths),B.pxAlign=y.pxAlign}if(tt){let U=Ee(y,A);$t.splice(A,0,U[0]),Ot.splice(A,0,U[1]),lt.values.push(null)}if(mt){nt.splice(A,0,null);let U=null;Rt?A==0&&(U=Go(y,A)):A>0&&(U=Go(y,A)),ue.splice(A,0,U),Ge.splice(A,0,0),Vn.splice(A,0,0)}En("addSeries",A)}function $h(y,A){A=A??M.length,y=s==1?Uu(y,A,hm,mm):Uu(y,A,{},pm),M.splice(A,0,y),Fr(M[A],A)}i.addSeries=$h;function ll(y){if(M.splice(y,1),tt){lt.values.splice(y,1),Ot.splice(y,1);let A=$t.splice(y,1)[0];mn(null,A.firstChild),A.remove()}mt&&(nt.splice(y,1),ue.splice(y,1)[0].remove(),Ge.splice(y,1),Vn.splice(y,1)),En("delSeries",y)}i.delSeries=ll;let Wi=[!1,!1,!1,!1];function ls(y,A){if(y._show=y.show,y.show){let U=y.side%2,B=S[y.scale];B==null&&(y.scale=U?M[1].scale:E,B=S[y.scale]);let X=B.time;y.size=ye(y.size),y.space=ye(y.space),y.rotate=ye(y.rotate),zs(y.incrs)&&y.incrs.forEach(ut=>{!ks.has(ut)&&ks.set(ut,Pm(ut))}),y.incrs=ye(y.incrs||(B.distr==2?_y:X?f==1?yy:My:gr)),y.splits=ye(y.splits||(X&&B.distr==1?Q:B.distr==3?Iu:B.distr==4?ky:zy)),y.stroke=ye(y.stroke),y.grid.stroke=ye(y.grid.stroke),y.ticks.stroke=ye(y.ticks.stroke),y.border.stroke=ye(y.border.stroke);let K=y.values;y.values=zs(K)&&!zs(K[0])?ye(K):X?zs(K)?om(H,rm(K,z)):em(K)?Ey(H,K):K||Y:K||By,y.filter=ye(y.filter||(B.distr>=3&&B.log==10?Hy:B.distr==3&&B.log==2?Wy:Rm)),y.font=Sm(y.font),y.labelFont=Sm(y.labelFont),y._size=y.size(i,null,A,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Wi[A]=!0,y._el=Si(Ax,u))}}function cs(y,A,U,B){let[X,K,ut,gt]=U,Mt=A%2,Ut=0;return Mt==0&&(gt||K)&&(Ut=A==0&&!X||A==2&&!ut?_n(cm.size/3):0),Mt==1&&(X||ut)&&(Ut=A==1&&!K||A==3&&!gt?_n(dm.size/2):0),Ut}let Ho=i.padding=(n.padding||[cs,cs,cs,cs]).map(y=>ye(we(y,cs))),Ti=i._padding=Ho.map((y,A)=>y(i,A,Wi,0)),Qe,sn=null,rn=null,Xi=s==1?M[0].idxs:null,oi=null,Cs=!1;function Wo(y,A){if(t=y??[],i.data=i._data=t,s==2){Qe=0;for(let U=1;U<M.length;U++)Qe+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),oi=t[0],Qe=oi.length;let U=t;if(D==2){U=t.slice();let B=U[0]=Array(Qe);for(let X=0;X<Qe;X++)B[X]=X}i._data=t=U}if(de(!0),En("setData"),D==2&&(St=!0),A!==!1){let U=b;U.auto(i,Cs)?Xo():Ls(E,U.min,U.max),it=it||ht.left>=0,xt=!0,Un()}}i.setData=Wo;function Xo(){Cs=!0;let y,A;s==1&&(Qe>0?(sn=Xi[0]=0,rn=Xi[1]=Qe-1,y=t[0][sn],A=t[0][rn],D==2?(y=sn,A=rn):y==A&&(D==3?[y,A]=Cl(y,y,b.log,!1):D==4?[y,A]=zu(y,y,b.log,!1):b.time?A=y+_n(86400/f):[y,A]=Tl(y,A,ku,!0))):(sn=Xi[0]=y=null,rn=Xi[1]=A=null)),Ls(E,y,A)}let Or,Ps,Br,R,W,et,J,j,Tt,Lt;function At(y,A,U,B,X,K){y??=Bp,U??=Gu,B??="butt",X??=Bp,K??="round",y!=Or&&(d.strokeStyle=Or=y),X!=Ps&&(d.fillStyle=Ps=X),A!=Br&&(d.lineWidth=Br=A),K!=W&&(d.lineJoin=W=K),B!=et&&(d.lineCap=et=B),U!=R&&d.setLineDash(R=U)}function Dt(y,A,U,B){A!=Ps&&(d.fillStyle=Ps=A),y!=J&&(d.font=J=y),U!=j&&(d.textAlign=j=U),B!=Tt&&(d.textBaseline=Tt=B)}function Gt(y,A,U,B,X=0){if(B.length>0&&y.auto(i,Cs)&&(A==null||A.min==null)){let K=we(sn,0),ut=we(rn,B.length-1),gt=U.min==null?Hx(B,K,ut,X,y.distr==3):[U.min,U.max];y.min=Li(y.min,U.min=gt[0]),y.max=qn(y.max,U.max=gt[1])}}let ne={min:null,max:null};function pe(){for(let B in S){let X=S[B];O[B]==null&&(X.min==null||O[E]!=null&&X.auto(i,Cs))&&(O[B]=ne)}for(let B in S){let X=S[B];O[B]==null&&X.from!=null&&O[X.from]!=null&&(O[B]=ne)}O[E]!=null&&de(!0);let y={};for(let B in O){let X=O[B];if(X!=null){let K=y[B]=no(S[B],Kx);if(X.min!=null)dn(K,X);else if(B!=E||s==2)if(Qe==0&&K.from==null){let ut=K.range(i,null,null,B);K.min=ut[0],K.max=ut[1]}else K.min=ze,K.max=-ze}}if(Qe>0){M.forEach((B,X)=>{if(s==1){let K=B.scale,ut=O[K];if(ut==null)return;let gt=y[K];if(X==0){let Mt=gt.range(i,gt.min,gt.max,K);gt.min=Mt[0],gt.max=Mt[1],sn=Ii(gt.min,t[0]),rn=Ii(gt.max,t[0]),rn-sn>1&&(t[0][sn]<gt.min&&sn++,t[0][rn]>gt.max&&rn--),B.min=oi[sn],B.max=oi[rn]}else B.show&&B.auto&&Gt(gt,ut,B,t[X],B.sorted);B.idxs[0]=sn,B.idxs[1]=rn}else if(X>0&&B.show&&B.auto){let[K,ut]=B.facets,gt=K.scale,Mt=ut.scale,[Ut,Ft]=t[X],zt=y[gt],oe=y[Mt];zt!=null&&Gt(zt,O[gt],K,Ut,K.sorted),oe!=null&&Gt(oe,O[Mt],ut,Ft,ut.sorted),B.min=ut.min,B.max=ut.max}});for(let B in y){let X=y[B],K=O[B];if(X.from==null&&(K==null||K.min==null)){let ut=X.range(i,X.min==ze?null:X.min,X.max==-ze?null:X.max,B);X.min=ut[0],X.max=ut[1]}}}for(let B in y){let X=y[B];if(X.from!=null){let K=y[X.from];if(K.min==null)X.min=X.max=null;else{let ut=X.range(i,K.min,K.max,B);X.min=ut[0],X.max=ut[1]}}}let A={},U=!1;for(let B in y){let X=y[B],K=S[B];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ut=K.distr;K._min=ut==3?ps(K.min):ut==4?Mu(K.min,K.asinh):ut==100?K.fwd(K.min):K.min,K._max=ut==3?ps(K.max):ut==4?Mu(K.max,K.asinh):ut==100?K.fwd(K.max):K.max,A[B]=U=!0}}if(U){M.forEach((B,X)=>{s==2?X>0&&A.y&&(B._paths=null):A[B.scale]&&(B._paths=null)});for(let B in A)St=!0,En("setScale",B);mt&&ht.left>=0&&(it=xt=!0)}for(let B in O)O[B]=null}function Vt(y){let A=Pu(sn-1,0,Qe-1),U=Pu(rn+1,0,Qe-1);for(;y[A]==null&&A>0;)A--;for(;y[U]==null&&U<Qe-1;)U++;return[A,U]}function me(){if(Qe>0){let y=M.some(A=>A._focus)&&Lt!=kt.alpha;y&&(d.globalAlpha=Lt=kt.alpha),M.forEach((A,U)=>{if(U>0&&A.show&&(Je(U,!1),Je(U,!0),A._paths==null)){let B=Lt;Lt!=A.alpha&&(d.globalAlpha=Lt=A.alpha);let X=s==2?[0,t[U][0].length-1]:Vt(t[U]);A._paths=A.paths(i,U,X[0],X[1]),Lt!=B&&(d.globalAlpha=Lt=B)}}),M.forEach((A,U)=>{if(U>0&&A.show){let B=Lt;Lt!=A.alpha&&(d.globalAlpha=Lt=A.alpha),A._paths!=null&&De(U,!1);{let X=A._paths!=null?A._paths.gaps:null,K=A.points.show(i,U,sn,rn,X),ut=A.points.filter(i,U,K,X);(K||ut)&&(A.points._paths=A.points.paths(i,U,sn,rn,ut),De(U,!0))}Lt!=B&&(d.globalAlpha=Lt=B),En("drawSeries",U)}}),y&&(d.globalAlpha=Lt=1)}}function Je(y,A){let U=A?M[y].points:M[y];U._stroke=U.stroke(i,y),U._fill=U.fill(i,y)}function De(y,A){let U=A?M[y].points:M[y],{stroke:B,fill:X,clip:K,flags:ut,_stroke:gt=U._stroke,_fill:Mt=U._fill,_width:Ut=U.width}=U._paths;Ut=ke(Ut*Ae,3);let Ft=null,zt=Ut%2/2;A&&Mt==null&&(Mt=Ut>0?"#fff":gt);let oe=U.pxAlign==1&&zt>0;if(oe&&d.translate(zt,zt),!A){let Te=N-Ut/2,be=w-Ut/2,ge=$+Ut,Qt=pt+Ut;Ft=new Path2D,Ft.rect(Te,be,ge,Qt)}A?Bt(gt,Ut,U.dash,U.cap,Mt,B,X,ut,K):Ne(y,gt,Ut,U.dash,U.cap,Mt,B,X,ut,Ft,K),oe&&d.translate(-zt,-zt)}function Ne(y,A,U,B,X,K,ut,gt,Mt,Ut,Ft){let zt=!1;Mt!=0&&C.forEach((oe,Te)=>{if(oe.series[0]==y){let be=M[oe.series[1]],ge=t[oe.series[1]],Qt=(be._paths||oa).band;zs(Qt)&&(Qt=oe.dir==1?Qt[0]:Qt[1]);let Yt,Xe=null;be.show&&Qt&&Xx(ge,sn,rn)?(Xe=oe.fill(i,Te)||K,Yt=be._paths.clip):Qt=null,Bt(A,U,B,X,Xe,ut,gt,Mt,Ut,Ft,Yt,Qt),zt=!0}}),zt||Bt(A,U,B,X,K,ut,gt,Mt,Ut,Ft)}let gn=io|Du;function Bt(y,A,U,B,X,K,ut,gt,Mt,Ut,Ft,zt){At(y,A,U,B,X),(Mt||Ut||zt)&&(d.save(),Mt&&d.clip(Mt),Ut&&d.clip(Ut)),zt?(gt&gn)==gn?(d.clip(zt),Ft&&d.clip(Ft),_e(X,ut),an(y,K,A)):gt&Du?(_e(X,ut),d.clip(zt),an(y,K,A)):gt&io&&(d.save(),d.clip(zt),Ft&&d.clip(Ft),_e(X,ut),d.restore(),an(y,K,A)):(_e(X,ut),an(y,K,A)),(Mt||Ut||zt)&&d.restore()}function an(y,A,U){U>0&&(A instanceof Map?A.forEach((B,X)=>{d.strokeStyle=Or=X,d.stroke(B)}):A!=null&&y&&d.stroke(A))}function _e(y,A){A instanceof Map?A.forEach((U,B)=>{d.fillStyle=Ps=B,d.fill(U)}):A!=null&&y&&d.fill(A)}function hs(y,A,U,B){let X=P[y],K;if(B<=0)K=[0,0];else{let ut=X._space=X.space(i,y,A,U,B),gt=X._incrs=X.incrs(i,y,A,U,B,ut);K=dv(A,U,gt,B,ut)}return X._found=K}function ln(y,A,U,B,X,K,ut,gt,Mt,Ut){let Ft=ut%2/2;x==1&&d.translate(Ft,Ft),At(gt,ut,Mt,Ut,gt),d.beginPath();let zt,oe,Te,be,ge=X+(B==0||B==3?-K:K);U==0?(oe=X,be=ge):(zt=X,Te=ge);for(let Qt=0;Qt<y.length;Qt++)A[Qt]!=null&&(U==0?zt=Te=y[Qt]:oe=be=y[Qt],d.moveTo(zt,oe),d.lineTo(Te,be));d.stroke(),x==1&&d.translate(-Ft,-Ft)}function zr(y){let A=!0;return P.forEach((U,B)=>{if(!U.show)return;let X=S[U.scale];if(X.min==null){U._show&&(A=!1,U._show=!1,de(!1));return}else U._show||(A=!1,U._show=!0,de(!1));let K=U.side,ut=K%2,{min:gt,max:Mt}=X,[Ut,Ft]=hs(B,gt,Mt,ut==0?V:Ct);if(Ft==0)return;let zt=X.distr==2,oe=U._splits=U.splits(i,B,gt,Mt,Ut,Ft,zt),Te=X.distr==2?oe.map(Yt=>oi[Yt]):oe,be=X.distr==2?oi[oe[1]]-oi[oe[0]]:Ut,ge=U._values=U.values(i,U.filter(i,Te,B,Ft,be),B,Ft,be);U._rotate=K==2?U.rotate(i,ge,B,Ft):0;let Qt=U._size;U._size=Mi(U.size(i,ge,B,y)),Qt!=null&&U._size!=Qt&&(A=!1)}),A}function qi(y){let A=!0;return Ho.forEach((U,B)=>{let X=U(i,B,Wi,y);X!=Ti[B]&&(A=!1),Ti[B]=X}),A}function us(){for(let y=0;y<P.length;y++){let A=P[y];if(!A.show||!A._show)continue;let U=A.side,B=U%2,X,K,ut=A.stroke(i,y),gt=U==0||U==3?-1:1,[Mt,Ut]=A._found;if(A.label!=null){let Wn=A.labelGap*gt,ci=_n((A._lpos+Wn)*Ae);Dt(A.labelFont[0],ut,"center",U==2?"top":Op),d.save(),B==1?(X=K=0,d.translate(ci,_n(w+pt/2)),d.rotate((U==3?-wl:wl)/2)):(X=_n(N+$/2),K=ci);let dr=Tm(A.label)?A.label(i,y,Mt,Ut):A.label;d.fillText(dr,X,K),d.restore()}if(Ut==0)continue;let Ft=S[A.scale],zt=B==0?$:pt,oe=B==0?N:w,Te=A._splits,be=Ft.distr==2?Te.map(Wn=>oi[Wn]):Te,ge=Ft.distr==2?oi[Te[1]]-oi[Te[0]]:Mt,Qt=A.ticks,Yt=A.border,Xe=Qt.show?Qt.size:0,en=_n(Xe*Ae),Tn=_n((A.alignTo==2?A._size-Xe-A.gap:A.gap)*Ae),Oe=A._rotate*-wl/180,nn=p(A._pos*Ae),ai=(en+Tn)*gt,Hn=nn+ai;K=B==0?Hn:0,X=B==1?Hn:0;let yi=A.font[0],Ai=A.align==1?jr:A.align==2?yu:Oe>0?jr:Oe<0?yu:B==0?"center":U==3?yu:jr,Zi=Oe||B==1?"middle":U==2?"top":Op;Dt(yi,ut,Ai,Zi);let li=A.font[1]*A.lineGap,vi=Te.map(Wn=>p(a(Wn,Ft,zt,oe))),Ri=A._values;for(let Wn=0;Wn<Ri.length;Wn++){let ci=Ri[Wn];if(ci!=null){B==0?X=vi[Wn]:K=vi[Wn],ci=""+ci;let dr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let Xn=0;Xn<dr.length;Xn++){let $f=dr[Xn];Oe?(d.save(),d.translate(X,K+Xn*li),d.rotate(Oe),d.fillText($f,0,0),d.restore()):d.fillText($f,X,K+Xn*li)}}}Qt.show&&ln(vi,Qt.filter(i,be,y,Ut,ge),B,U,nn,en,ke(Qt.width*Ae,3),Qt.stroke(i,y),Qt.dash,Qt.cap);let Ji=A.grid;Ji.show&&ln(vi,Ji.filter(i,be,y,Ut,ge),B,B==0?2:1,B==0?w:N,B==0?pt:$,ke(Ji.width*Ae,3),Ji.stroke(i,y),Ji.dash,Ji.cap),Yt.show&&ln([nn],[1],B==0?1:0,B==0?1:2,B==1?w:N,B==1?pt:$,ke(Yt.width*Ae,3),Yt.stroke(i,y),Yt.dash,Yt.cap)}En("drawAxes")}function de(y){M.forEach((A,U)=>{U>0&&(A._paths=null,y&&(s==1?(A.min=null,A.max=null):A.facets.forEach(B=>{B.min=null,B.max=null})))})}let tn=!1,Gn=!1,Ue=[];function cn(){Gn=!1;for(let y=0;y<Ue.length;y++)En(...Ue[y]);Ue.length=0}function Un(){tn||(ry(Pf),tn=!0)}function cl(y,A=!1){tn=!0,Gn=A,y(i),Pf(),A&&Ue.length>0&&queueMicrotask(cn)}i.batch=cl;function Pf(){if(ct&&(pe(),ct=!1),St&&(Et(),St=!1),vt){if(Ye(m,jr,jt),Ye(m,"top",le),Ye(m,na,V),Ye(m,ia,Ct),Ye(g,jr,jt),Ye(g,"top",le),Ye(g,na,V),Ye(g,ia,Ct),Ye(u,na,Ke),Ye(u,ia,on),h.width=_n(Ke*Ae),h.height=_n(on*Ae),P.forEach(({_el:y,_show:A,_size:U,_pos:B,side:X})=>{if(y!=null)if(A){let K=X===3||X===0?U:0,ut=X%2==1;Ye(y,ut?"left":"top",B-K),Ye(y,ut?"width":"height",U),Ye(y,ut?"top":"left",ut?le:jt),Ye(y,ut?"height":"width",ut?Ct:V),Ru(y,_r)}else hi(y,_r)}),Or=Ps=Br=W=et=J=j=Tt=R=null,Lt=1,$o(!0),jt!=wt||le!=Be||V!=Wt||Ct!=Zt){de(!1);let y=V/Wt,A=Ct/Zt;if(mt&&!it&&ht.left>=0){ht.left*=y,ht.top*=A,kr&&Ki(kr,_n(ht.left),0,V,Ct),Vr&&Ki(Vr,0,_n(ht.top),V,Ct);for(let U=0;U<ue.length;U++){let B=ue[U];B!=null&&(Ge[U]*=y,Vn[U]*=A,Ki(B,Mi(Ge[U]),Mi(Vn[U]),V,Ct))}}if(We.show&&!rt&&We.left>=0&&We.width>0){We.left*=y,We.width*=y,We.top*=A,We.height*=A;for(let U in tu)Ye(Wr,U,We[U])}wt=jt,Be=le,Wt=V,Zt=Ct}En("setSize"),vt=!1}Ke>0&&on>0&&(d.clearRect(0,0,h.width,h.height),En("drawClear"),v.forEach(y=>y()),En("draw")),We.show&&rt&&(hl(We),rt=!1),mt&&it&&(ur(null,!0,!1),it=!1),lt.show&&lt.live&&xt&&(Kh(),xt=!1),c||(c=!0,i.status=1,En("ready")),Cs=!1,tn=!1}i.redraw=(y,A)=>{St=A||!1,y!==!1?Ls(E,b.min,b.max):Un()};function Zh(y,A){let U=S[y];if(U.from==null){if(Qe==0){let B=U.range(i,A.min,A.max,y);A.min=B[0],A.max=B[1]}if(A.min>A.max){let B=A.min;A.min=A.max,A.max=B}if(Qe>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;y==E&&U.distr==2&&Qe>0&&(A.min=Ii(A.min,t[0]),A.max=Ii(A.max,t[0]),A.min==A.max&&A.max++),O[y]=A,ct=!0,Un()}}i.setScale=Zh;let Jh,jh,kr,Vr,If,Lf,Gr,Hr,Df,Nf,He,Ze,Is=!1,Rn=ht.drag,bn=Rn.x,wn=Rn.y;mt&&(ht.x&&(Jh=Si(Cx,g)),ht.y&&(jh=Si(Px,g)),b.ori==0?(kr=Jh,Vr=jh):(kr=jh,Vr=Jh),He=ht.left,Ze=ht.top);let We=i.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Wr=We.show?Si(Rx,We.over?g:m):null;function hl(y,A){if(We.show){for(let U in y)We[U]=y[U],U in tu&&Ye(Wr,U,y[U]);A!==!1&&En("setSelect")}}i.setSelect=hl;function C_(y){if(M[y].show)tt&&Ru($t[y],_r);else if(tt&&hi($t[y],_r),mt){let U=Rt?ue[0]:ue[y];U!=null&&Ki(U,-10,-10,V,Ct)}}function Ls(y,A,U){Zh(y,{min:A,max:U})}function Yi(y,A,U,B){A.focus!=null&&N_(y),A.show!=null&&M.forEach((X,K)=>{K>0&&(y==K||y==null)&&(X.show=A.show,C_(K),s==2?(Ls(X.facets[0].scale,null,null),Ls(X.facets[1].scale,null,null)):Ls(X.scale,null,null),Un())}),U!==!1&&En("setSeries",y,A),B&&Zo("setSeries",i,y,A)}i.setSeries=Yi;function P_(y,A){dn(C[y],A)}function I_(y,A){y.fill=ye(y.fill||null),y.dir=we(y.dir,-1),A=A??C.length,C.splice(A,0,y)}function L_(y){y==null?C.length=0:C.splice(y,1)}i.addBand=I_,i.setBand=P_,i.delBand=L_;function D_(y,A){M[y].alpha=A,mt&&ue[y]!=null&&(ue[y].style.opacity=A),tt&&$t[y]&&($t[y].style.opacity=A)}let ds,Ds,hr,Xr={focus:!0};function N_(y){if(y!=hr){let A=y==null,U=kt.alpha!=1;M.forEach((B,X)=>{if(s==1||X>0){let K=A||X==0||X==y;B._focus=A?null:K,U&&D_(X,K?1:kt.alpha)}}),hr=y,U&&Un()}}tt&&ee&&Me(Vp,ot,y=>{ht._lock||(te(y),hr!=null&&Yi(null,Xr,!0,hn.setSeries))});function $i(y,A,U){let B=S[A];U&&(y=y/Ae-(B.ori==1?le:jt));let X=V;B.ori==1&&(X=Ct,y=X-y),B.dir==-1&&(y=X-y);let K=B._min,ut=B._max,gt=y/X,Mt=K+(ut-K)*gt,Ut=B.distr;return Ut==3?to(10,Mt):Ut==4?Yx(Mt,B.asinh):Ut==100?B.bwd(Mt):Mt}function U_(y,A){let U=$i(y,E,A);return Ii(U,t[0],sn,rn)}i.valToIdx=y=>Ii(y,t[0]),i.posToIdx=U_,i.posToVal=$i,i.valToPos=(y,A,U)=>S[A].ori==0?r(y,S[A],U?$:V,U?N:0):o(y,S[A],U?pt:Ct,U?w:0),i.setCursor=(y,A,U)=>{He=y.left,Ze=y.top,ur(null,A,U)};function Uf(y,A){Ye(Wr,jr,We.left=y),Ye(Wr,na,We.width=A)}function Ff(y,A){Ye(Wr,"top",We.top=y),Ye(Wr,ia,We.height=A)}let qo=b.ori==0?Uf:Ff,Yo=b.ori==1?Uf:Ff;function F_(){if(tt&&lt.live)for(let y=s==2?1:0;y<M.length;y++){if(y==0&&ae)continue;let A=lt.values[y],U=0;for(let B in A)Ot[y][U++].firstChild.nodeValue=A[B]}}function Kh(y,A){if(y!=null&&(y.idxs?y.idxs.forEach((U,B)=>{nt[B]=U}):jx(y.idx)||nt.fill(y.idx),lt.idx=nt[0]),tt&&lt.live){for(let U=0;U<M.length;U++)(U>0||s==1&&!ae)&&O_(U,nt[U]);F_()}xt=!1,A!==!1&&En("setLegend")}i.setLegend=Kh;function O_(y,A){let U=M[y],B=y==0&&D==2?oi:t[y],X;ae?X=U.values(i,y,A)??Xt:(X=U.value(i,A==null?null:B[A],y,A),X=X==null?Xt:{_:X}),lt.values[y]=X}function ur(y,A,U){Df=He,Nf=Ze,[He,Ze]=ht.move(i,He,Ze),ht.left=He,ht.top=Ze,mt&&(kr&&Ki(kr,_n(He),0,V,Ct),Vr&&Ki(Vr,0,_n(Ze),V,Ct));let B,X=sn>rn;ds=ze,Ds=null;let K=b.ori==0?V:Ct,ut=b.ori==1?V:Ct;if(He<0||Qe==0||X){B=ht.idx=null;for(let gt=0;gt<M.length;gt++){let Mt=ue[gt];Mt!=null&&Ki(Mt,-10,-10,V,Ct)}ee&&Yi(null,Xr,!0,y==null&&hn.setSeries),lt.live&&(nt.fill(B),xt=!0)}else{let gt,Mt,Ut;s==1&&(gt=b.ori==0?He:Ze,Mt=$i(gt,E),B=ht.idx=Ii(Mt,t[0],sn,rn),Ut=F(t[0][B],b,K,0));let Ft=-10,zt=-10,oe=0,Te=0,be=!0,ge="",Qt="";for(let Yt=s==2?1:0;Yt<M.length;Yt++){let Xe=M[Yt],en=nt[Yt],Tn=en==null?null:s==1?t[Yt][en]:t[Yt][1][en],Oe=ht.dataIdx(i,Yt,B,Mt),nn=Oe==null?null:s==1?t[Yt][Oe]:t[Yt][1][Oe];if(xt=xt||nn!=Tn||Oe!=en,nt[Yt]=Oe,Yt>0&&Xe.show){let ai=Oe==null?-10:Oe==B?Ut:F(s==1?t[0][Oe]:t[Yt][0][Oe],b,K,0),Hn=nn==null?-10:I(nn,s==1?S[Xe.scale]:S[Xe.facets[1].scale],ut,0);if(ee&&nn!=null){let yi=b.ori==1?He:Ze,Ai=xn(kt.dist(i,Yt,Oe,Hn,yi));if(Ai<ds){let Zi=kt.bias;if(Zi!=0){let li=$i(yi,Xe.scale),vi=nn>=0?1:-1,Ri=li>=0?1:-1;Ri==vi&&(Ri==1?Zi==1?nn>=li:nn<=li:Zi==1?nn<=li:nn>=li)&&(ds=Ai,Ds=Yt)}else ds=Ai,Ds=Yt}}if(xt||Rt){let yi,Ai;b.ori==0?(yi=ai,Ai=Hn):(yi=Hn,Ai=ai);let Zi,li,vi,Ri,Ji,Wn,ci=!0,dr=ft.bbox;if(dr!=null){ci=!1;let Xn=dr(i,Yt);vi=Xn.left,Ri=Xn.top,Zi=Xn.width,li=Xn.height}else vi=yi,Ri=Ai,Zi=li=ft.size(i,Yt);if(Wn=ft.fill(i,Yt),Ji=ft.stroke(i,Yt),Rt)Yt==Ds&&ds<=kt.prox&&(Ft=vi,zt=Ri,oe=Zi,Te=li,be=ci,ge=Wn,Qt=Ji);else{let Xn=ue[Yt];Xn!=null&&(Ge[Yt]=vi,Vn[Yt]=Ri,$p(Xn,Zi,li,ci),qp(Xn,Wn,Ji),Ki(Xn,Mi(vi),Mi(Ri),V,Ct))}}}}if(Rt){let Yt=kt.prox,Xe=hr==null?ds<=Yt:ds>Yt||Ds!=hr;if(xt||Xe){let en=ue[0];en!=null&&(Ge[0]=Ft,Vn[0]=zt,$p(en,oe,Te,be),qp(en,ge,Qt),Ki(en,Mi(Ft),Mi(zt),V,Ct))}}}if(We.show&&Is)if(y!=null){let[gt,Mt]=hn.scales,[Ut,Ft]=hn.match,[zt,oe]=y.cursor.sync.scales,Te=y.cursor.drag;if(bn=Te._x,wn=Te._y,bn||wn){let{left:be,top:ge,width:Qt,height:Yt}=y.select,Xe=y.scales[zt].ori,en=y.posToVal,Tn,Oe,nn,ai,Hn,yi=gt!=null&&Ut(gt,zt),Ai=Mt!=null&&Ft(Mt,oe);yi&&bn?(Xe==0?(Tn=be,Oe=Qt):(Tn=ge,Oe=Yt),nn=S[gt],ai=F(en(Tn,zt),nn,K,0),Hn=F(en(Tn+Oe,zt),nn,K,0),qo(Li(ai,Hn),xn(Hn-ai))):qo(0,K),Ai&&wn?(Xe==1?(Tn=be,Oe=Qt):(Tn=ge,Oe=Yt),nn=S[Mt],ai=I(en(Tn,oe),nn,ut,0),Hn=I(en(Tn+Oe,oe),nn,ut,0),Yo(Li(ai,Hn),xn(Hn-ai))):Yo(0,ut)}else eu()}else{let gt=xn(Df-If),Mt=xn(Nf-Lf);if(b.ori==1){let oe=gt;gt=Mt,Mt=oe}bn=Rn.x&&gt>=Rn.dist,wn=Rn.y&&Mt>=Rn.dist;let Ut=Rn.uni;Ut!=null?bn&&wn&&(bn=gt>=Ut,wn=Mt>=Ut,!bn&&!wn&&(Mt>gt?wn=!0:bn=!0)):Rn.x&&Rn.y&&(bn||wn)&&(bn=wn=!0);let Ft,zt;bn&&(b.ori==0?(Ft=Gr,zt=He):(Ft=Hr,zt=Ze),qo(Li(Ft,zt),xn(zt-Ft)),wn||Yo(0,ut)),wn&&(b.ori==1?(Ft=Gr,zt=He):(Ft=Hr,zt=Ze),Yo(Li(Ft,zt),xn(zt-Ft)),bn||qo(0,K)),!bn&&!wn&&(qo(0,0),Yo(0,0))}if(Rn._x=bn,Rn._y=wn,y==null){if(U){if(Yf!=null){let[gt,Mt]=hn.scales;hn.values[0]=gt!=null?$i(b.ori==0?He:Ze,gt):null,hn.values[1]=Mt!=null?$i(b.ori==1?He:Ze,Mt):null}Zo(vu,i,He,Ze,V,Ct,B)}if(ee){let gt=U&&hn.setSeries,Mt=kt.prox;hr==null?ds<=Mt&&Yi(Ds,Xr,!0,gt):ds>Mt?Yi(null,Xr,!0,gt):Ds!=hr&&Yi(Ds,Xr,!0,gt)}}xt&&(lt.idx=B,Kh()),A!==!1&&En("setCursor")}let Ns=null;Object.defineProperty(i,"rect",{get(){return Ns==null&&$o(!1),Ns}});function $o(y=!1){y?Ns=null:(Ns=g.getBoundingClientRect(),En("syncRect",Ns))}function Of(y,A,U,B,X,K,ut){ht._lock||Is&&y!=null&&y.movementX==0&&y.movementY==0||(Qh(y,A,U,B,X,K,ut,!1,y!=null),y!=null?ur(null,!0,!0):ur(A,!0,!1))}function Qh(y,A,U,B,X,K,ut,gt,Mt){if(Ns==null&&$o(!1),te(y),y!=null)U=y.clientX-Ns.left,B=y.clientY-Ns.top;else{if(U<0||B<0){He=-10,Ze=-10;return}let[Ut,Ft]=hn.scales,zt=A.cursor.sync,[oe,Te]=zt.values,[be,ge]=zt.scales,[Qt,Yt]=hn.match,Xe=A.axes[0].side%2==1,en=b.ori==0?V:Ct,Tn=b.ori==1?V:Ct,Oe=Xe?K:X,nn=Xe?X:K,ai=Xe?B:U,Hn=Xe?U:B;if(be!=null?U=Qt(Ut,be)?a(oe,S[Ut],en,0):-10:U=en*(ai/Oe),ge!=null?B=Yt(Ft,ge)?a(Te,S[Ft],Tn,0):-10:B=Tn*(Hn/nn),b.ori==1){let yi=U;U=B,B=yi}}Mt&&(A==null||A.cursor.event.type==vu)&&((U<=1||U>=V-1)&&(U=mr(U,V)),(B<=1||B>=Ct-1)&&(B=mr(B,Ct))),gt?(If=U,Lf=B,[Gr,Hr]=ht.move(i,U,B)):(He=U,Ze=B)}let tu={width:0,height:0,left:0,top:0};function eu(){hl(tu,!1)}let Bf,zf,kf,Vf;function Gf(y,A,U,B,X,K,ut){Is=!0,bn=wn=Rn._x=Rn._y=!1,Qh(y,A,U,B,X,K,ut,!0,!1),y!=null&&(Me(Su,Tu,Hf,!1),Zo(zp,i,Gr,Hr,V,Ct,null));let{left:gt,top:Mt,width:Ut,height:Ft}=We;Bf=gt,zf=Mt,kf=Ut,Vf=Ft}function Hf(y,A,U,B,X,K,ut){Is=Rn._x=Rn._y=!1,Qh(y,A,U,B,X,K,ut,!1,!0);let{left:gt,top:Mt,width:Ut,height:Ft}=We,zt=Ut>0||Ft>0,oe=Bf!=gt||zf!=Mt||kf!=Ut||Vf!=Ft;if(zt&&oe&&hl(We),Rn.setScale&&zt&&oe){let Te=gt,be=Ut,ge=Mt,Qt=Ft;if(b.ori==1&&(Te=Mt,be=Ft,ge=gt,Qt=Ut),bn&&Ls(E,$i(Te,E),$i(Te+be,E)),wn)for(let Yt in S){let Xe=S[Yt];Yt!=E&&Xe.from==null&&Xe.min!=ze&&Ls(Yt,$i(ge+Qt,Yt),$i(ge,Yt))}eu()}else ht.lock&&(ht._lock=!ht._lock,ur(A,!0,y!=null));y!=null&&(mn(Su,Tu),Zo(Su,i,He,Ze,V,Ct,null))}function B_(y,A,U,B,X,K,ut){if(ht._lock)return;te(y);let gt=Is;if(Is){let Mt=!0,Ut=!0,Ft=10,zt,oe;b.ori==0?(zt=bn,oe=wn):(zt=wn,oe=bn),zt&&oe&&(Mt=He<=Ft||He>=V-Ft,Ut=Ze<=Ft||Ze>=Ct-Ft),zt&&Mt&&(He=He<Gr?0:V),oe&&Ut&&(Ze=Ze<Hr?0:Ct),ur(null,!0,!0),Is=!1}He=-10,Ze=-10,nt.fill(null),ur(null,!0,!0),gt&&(Is=gt)}function Wf(y,A,U,B,X,K,ut){ht._lock||(te(y),Xo(),eu(),y!=null&&Zo(Gp,i,He,Ze,V,Ct,null))}function Xf(){P.forEach(fv),k(i.width,i.height,!0)}xr(El,Qr,Xf);let qr={};qr.mousedown=Gf,qr.mousemove=Of,qr.mouseup=Hf,qr.dblclick=Wf,qr.setSeries=(y,A,U,B)=>{let X=hn.match[2];U=X(i,A,U),U!=-1&&Yi(U,B,!0,!1)},mt&&(Me(zp,g,Gf),Me(vu,g,Of),Me(kp,g,y=>{te(y),$o(!1)}),Me(Vp,g,B_),Me(Gp,g,Wf),Nu.add(i),i.syncRect=$o);let ul=i.hooks=n.hooks||{};function En(y,A,U){Gn?Ue.push([y,A,U]):y in ul&&ul[y].forEach(B=>{B.call(null,i,A,U)})}(n.plugins||[]).forEach(y=>{for(let A in y.hooks)ul[A]=(ul[A]||[]).concat(y.hooks[A])});let qf=(y,A,U)=>U,hn=dn({key:null,setSeries:!1,filters:{pub:Qp,sub:Qp},scales:[E,M[1]?M[1].scale:null],match:[tm,tm,qf],values:[null,null]},ht.sync);hn.match.length==2&&hn.match.push(qf),ht.sync=hn;let Yf=hn.key,nu=Jm(Yf);function Zo(y,A,U,B,X,K,ut){hn.filters.pub(y,A,U,B,X,K,ut)&&nu.pub(y,A,U,B,X,K,ut)}nu.sub(i);function z_(y,A,U,B,X,K,ut){hn.filters.sub(y,A,U,B,X,K,ut)&&qr[y](null,A,U,B,X,K,ut)}i.pub=z_;function k_(){nu.unsub(i),Nu.delete(i),Mn.clear(),Cu(El,Qr,Xf),l.remove(),ot?.remove(),En("destroy")}i.destroy=k_;function iu(){En("init",n,t),Wo(t||n.data,!1),O[E]?Zh(E,O[E]):Xo(),rt=We.show&&(We.width>0||We.height>0),it=xt=!0,k(n.width,n.height)}return M.forEach(Fr),P.forEach(ls),e?e instanceof HTMLElement?(e.appendChild(l),iu()):e(i,iu):iu(),i}Pn.assign=dn;Pn.fmtNum=Vu;Pn.rangeNum=Tl;Pn.rangeLog=Cl;Pn.rangeAsinh=zu;Pn.orient=vr;Pn.pxRatio=Ae;Pn.join=sy;Pn.fmtDate=Hu,Pn.tzDate=my;Pn.sync=Jm;{Pn.addGap=jy,Pn.clipGaps=Ll;let n=Pn.paths={points:ng};n.linear=sg,n.stepped=tv,n.bars=ev,n.spline=iv}var pv="robot-dynamics",Sr=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function mv(n){let{joints:t,ofBase:e,units:i,trajectory:s}=n,{name:r}=n.tip(),o=(d,u,m)=>({values:s[d].map(g=>g[u]*m),now:g=>g[d][u]*m}),a=(d,u,m,g)=>({key:d,title:u,curves:t.map((x,p)=>({joint:p,name:x.name,unit:m(x.type),color:`--joint-${p%8}`,isDashed:p>=8,...o(d,d==="q"?p:e+p,g?i.factor(x.type):1)}))}),c=(d,u,m,g,x,p)=>({joint:null,name:d,sign:u,values:m,unit:g,color:x,now:p}),l=d=>s.tip.map(u=>u[d]),h=[a("q",["q","positions"],i.position,!0),a("qd",["q\u0307","velocities"],i.velocity,!0),a("qdd",["q\u0308","accelerations"],i.acceleration,!0),a("tau",["\u03C4","torques and forces"],i.force,!1),{key:"energy",title:["E","energies"],curves:[c("kinetic","T",s.kinetic,"J","--joint-0",({kinetic:d})=>d),c("potential","U",s.potential,"J","--joint-1",({potential:d})=>d),c("total","T+U",s.total,"J","--ink",({kinetic:d,potential:u})=>d+u)]},{key:"tip",title:["p",r],curves:[0,1,2].map(d=>c("xyz"[d],"xyz"[d],l(d),"m",`--axis-${"xyz"[d]}`,({tip:u})=>u[d][3]))}];return e>0?[...h.filter(({curves:d})=>d.length>0),...gv(n,o)]:h}function gv({freedoms:n,ofBase:t,units:e,trajectory:i},s){let r=(l,h,d,u,m)=>({key:`base-${l}`,title:h,curves:n.slice(0,t).map((g,x)=>({joint:null,name:g.name,sign:d(g),unit:u(g.type),color:`--axis-${g.axis}`,isDashed:x>=3,...s(l,x,m?e.factor(g.type):1)}))}),o=[0,1,2].map(l=>({joint:null,name:"xyz"[l],sign:"xyz"[l],unit:"m",color:`--axis-${"xyz"[l]}`,values:i.base.map(h=>ji(h)[l]),now:({base:h})=>ji(h)[l]})),a=({velocity:l,axis:h})=>`${l}${h}`,c=({force:l,axis:h})=>`${l}${h}`;return[{key:"base",title:["p","base"],curves:o},r("qd",["v, \u03C9","of the base"],a,e.velocity,!0),r("tau",["f, n","acting on the base"],c,e.force,!1)]}function _v(n,t){if(n===null||!Number.isFinite(n+t))return[-1,1];let e=t-n,i=Math.max(Math.abs(n),Math.abs(t));return e<=1e-9*i||e<1e-12?i<1e-12?[-1,1]:[n-.5*i,t+.5*i]:[n-.06*e,t+.06*e]}function xv(n,t,e,i){let[s,r,o]=["--ink","--line","--muted"].map(Sr),a=[...new Set(n.curves.map(({unit:h})=>h))],c="11px system-ui, sans-serif",l=(h,d,u)=>({scale:h,side:d,stroke:o,font:c,size:46,gap:3,grid:{show:u,stroke:r,width:1},ticks:{show:!1},values:(m,g)=>g.map(x=>String(Number(x.toPrecision(6))))});return{width:t,height:e,padding:[8,a.length>1?0:12,0,0],legend:{show:!1},cursor:{sync:{key:pv},drag:{x:!1,y:!1},points:{size:6},y:!1},focus:{alpha:.3},scales:{x:{time:!1,range:()=>[i[0],i[i.length-1]||1]},...Object.fromEntries(a.map(h=>[h,{range:(d,u,m)=>_v(u,m)}]))},axes:[{stroke:o,font:c,size:26,gap:3,grid:{stroke:r,width:1},ticks:{show:!1},values:(h,d)=>d.map(u=>`${Number(u.toPrecision(6))}`)},...a.map((h,d)=>l(h,d===0?3:1,d===0))],series:[{},...n.curves.map(({name:h,unit:d,color:u,isDashed:m})=>({label:h,scale:d,stroke:Sr(u)||s,width:1.8,dash:m?[5,4]:void 0,points:{show:!1}}))]}}function lg(n){let{joints:t}=n,e=new Set,i=G("div",{class:"plots"}),s=G("p",{class:"status",role:"status","data-key":"status"}),r=[],o=G("div",{class:"legend",role:"group","aria-label":"Joints in the plots"},t.map((x,p)=>{let f=G("button",{type:"button",class:"chip","aria-pressed":!0});return f.style.setProperty("--color",`var(--joint-${p%8})`),f.append(G("span",{class:"dot"}),x.name),f.addEventListener("click",()=>{e.delete(p)||e.add(p),f.setAttribute("aria-pressed",!e.has(p)),r.forEach(({plot:M,chart:P,readings:S})=>M.curves.forEach(({joint:C},E)=>{C===p&&(P.setSeries(E+1,{show:!e.has(p)}),S[E].hidden=e.has(p))}))}),f})),a=G("button",{type:"button",class:"quiet","data-key":"csv"},"Save as CSV");a.addEventListener("click",()=>{let x=n.freedoms.map(M=>M.name),p=Ip(n.trajectory,x),f=G("a",{href:URL.createObjectURL(new Blob([p],{type:"text/csv"}))});f.download=`${n.table.name}.csv`,f.click(),setTimeout(()=>URL.revokeObjectURL(f.href),1e3)});function c(){let{trajectory:x}=n;if(r.forEach(({chart:f})=>f.destroy()),r=[],i.replaceChildren(),g.hidden=x===null,!x)return;d();let p=x.t.length>1;if(a.disabled=!p,!!p){for(let f of mv(n)){let[M,P]=f.title,S=[...new Set(f.curves.map(({unit:D})=>D))],C=f.curves.map(({color:D,sign:F,joint:I})=>{let O=G("span",{class:"reading"});return O.style.setProperty("--color",`var(${D})`),O.append(...F?[G("i",{},F)]:un(M,I+1)," ",G("data")),O}),E=G("div",{class:"chart",role:"img","aria-label":`${P} over time, ${S.join(" and ")}`}),_=G("figure",{"data-plot":f.key},G("figcaption",{},G("b",{},G("i",{},M)),` ${P}, ${S.join(" and ")}`),G("div",{class:"readings"},C),E);i.append(_);let v=168,L=[x.t,...f.curves.map(({values:D})=>D)],T=new Pn(xv(f,Math.max(E.clientWidth,120),v,x.t),L,E),b=G("div",{class:"playhead"});T.over.append(b),l(T),f.curves.forEach(({joint:D},F)=>{D===null||!e.has(D)||(T.setSeries(F+1,{show:!1}),C[F].hidden=!0)}),r.push({plot:f,chart:T,head:b,readings:C,canvas:E})}m(),h()}}function l(x){let p=f=>{let{left:M}=x.over.getBoundingClientRect();n.play(!1),n.setTime(x.posToVal(f.clientX-M,"x"))};x.over.addEventListener("pointerdown",f=>{x.over.setPointerCapture(f.pointerId),p(f)}),x.over.addEventListener("pointermove",f=>{x.over.hasPointerCapture(f.pointerId)&&p(f)})}function h(){let{trajectory:x,state:p}=n;if(!x||r.length===0)return;let f=n.evaluated();for(let{plot:M,chart:P,head:S,readings:C}of r)S.style.transform=`translateX(${P.valToPos(p.t,"x")}px)`,M.curves.forEach(({now:E},_)=>{let v=C[_].lastChild;v.value=String(E(f)),v.textContent=Jo(E(f))})}function d(){let{trajectory:x,state:p,table:f}=n,M=[],P=x.t.length>1;if(x.ended){let{t:S,reason:C}=x.ended;M.push(P?`Ends at ${Jo(S)} s: ${C}.`:`The motion cannot begin: ${C}.`)}if(p.mode==="free"&&P){let S=x.energyScale>0?x.drift/x.energyScale:0;M.push(`Integrated by DOP853. Energy and work balance to ${x.drift.toExponential(1)} J, ${S.toExponential(1)} of what is exchanged.`);let C=t.filter((E,_)=>{let{limits:v}=f.rows.find(L=>L.joint===_);return v&&x.q.some(L=>L[_]<v[0]-1e-9||L[_]>v[1]+1e-9)});C.length>0&&M.push(`Limits are no stops here: ${C.map(E=>E.name).join(", ")} passed them.`)}s.textContent=M.join(" "),s.classList.toggle("warning",!!x.ended)}let u=new ResizeObserver(()=>{for(let{chart:x,canvas:p}of r){let f=p.clientWidth;f>0&&f!==x.width&&x.setSize({width:f,height:x.height})}h()}),m=()=>r.forEach(({canvas:x})=>u.observe(x)),g=G("section",{class:"panel","aria-label":"Plots"},G("div",{class:"bar"},o,a),s,i);return n.on("trajectory units theme",()=>g.isConnected&&c()),n.on("time",h),{section:g,build:c}}var Qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},tr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},kg=0,Ed=1,Vg=2;var Xa=1,Gg=2,No=3,er=0,ti=1,ns=2,Rr=0,Uo=1,Td=2,Ad=3,Rd=4,Hg=5;var Cr=100,Wg=101,Xg=102,qg=103,Yg=104,$g=200,Zg=201,Jg=202,jg=203,Cd=204,Pd=205,Kg=206,Qg=207,t0=208,e0=209,n0=210,i0=211,s0=212,r0=213,o0=214,ac=0,lc=1,cc=2,wo=3,hc=4,uc=5,dc=6,fc=7,Id=0,a0=1,l0=2,is=0,Ld=1,Dd=2,Nd=3,Ud=4,Fd=5,Od=6,Bd=7;var zd=300,Pr=301,Fo=302,Wc=303,Xc=304,pc=1e3,ts=1001,mc=1002,pn=1003,c0=1004;var qa=1005;var jn=1006,qc=1007;var Es=1008;var si=1009,kd=1010,Vd=1011,Oo=1012,Yc=1013,ki=1014,Vi=1015,Gi=1016,$c=1017,Zc=1018,Ir=1020,Gd=35902,Hd=35899,Wd=1021,Xd=1022,Hi=1023,Ms=1026,Ts=1027,qd=1028,Jc=1029,nr=1030,jc=1031;var Kc=1033,Ya=33776,$a=33777,Za=33778,Ja=33779,Qc=35840,th=35841,eh=35842,nh=35843,ih=36196,sh=37492,rh=37496,oh=37488,ah=37489,ja=37490,lh=37491,ch=37808,hh=37809,uh=37810,dh=37811,fh=37812,ph=37813,mh=37814,gh=37815,_h=37816,xh=37817,yh=37818,vh=37819,Sh=37820,Mh=37821,bh=36492,wh=36494,Eh=36495,Th=36283,Ah=36284,Ka=36285,Rh=36286;var ga=2300,gc=2301,rc=2302,xd=2303,yd=2400,vd=2401,Sd=2402;var h0=3200;var Ch=0,u0=1,As="",$n="srgb",_a="srgb-linear",xa="linear",Ie="srgb";var oc=7680;var d0=519,f0=512,p0=513,m0=514,Yd=515,g0=516,_0=517,$d=518,Zd=519,Jd=35044;var jd="300 es",wi=2e3,Eo=2001;function yv(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function vv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ya(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function x0(){let n=ya("canvas");return n.style.display="block",n}var cg={},To=null;function va(...n){let t="THREE."+n.shift();To?To("log",t,...n):console.log(t,...n)}function y0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Jt(...n){n=y0(n);let t="THREE."+n.shift();if(To)To("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=y0(n);let t="THREE."+n.shift();if(To)To("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function fa(...n){let t=n.join(" ");t in cg||(cg[t]=!0,Jt(...n))}function v0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var S0={[ac]:ac,[cc]:dc,[hc]:hc,[wo]:uc,[lc]:lc,[dc]:cc,[fc]:fc,[uc]:wo},Oi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],hg=1234567,pa=Math.PI/180,Ao=180/Math.PI;function ir(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]+"-"+On[t&255]+On[t>>8&255]+"-"+On[t>>16&15|64]+On[t>>24&255]+"-"+On[e&63|128]+On[e>>8&255]+"-"+On[e>>16&255]+On[e>>24&255]+On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]).toLowerCase()}function ce(n,t,e){return Math.max(t,Math.min(e,n))}function Kd(n,t){return(n%t+t)%t}function Sv(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Mv(n,t,e){return n!==t?(e-n)/(t-n):0}function ma(n,t,e){return(1-e)*n+e*t}function bv(n,t,e,i){return ma(n,t,1-Math.exp(-e*i))}function wv(n,t=1){return t-Math.abs(Kd(n,t*2)-t)}function Ev(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Tv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Av(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Rv(n,t){return n+Math.random()*(t-n)}function Cv(n){return n*(.5-Math.random())}function Pv(n){n!==void 0&&(hg=n);let t=hg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Iv(n){return n*pa}function Lv(n){return n*Ao}function Dv(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Nv(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Qd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Uv(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),h=o((t+i)/2),d=r((t-i)/2),u=o((t-i)/2),m=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*h,c*d,c*u,a*l);break;case"YZY":n.set(c*u,a*h,c*d,a*l);break;case"ZXZ":n.set(c*d,c*u,a*h,a*l);break;case"XZX":n.set(a*h,c*g,c*m,a*l);break;case"YXY":n.set(c*m,a*h,c*g,a*l);break;case"ZYZ":n.set(c*g,c*m,a*h,a*l);break;default:Jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ph(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function tf(n,t){if(t.constructor===Float32Array)return n;let e=Ph(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function ef(n,t){if(t.constructor===Float32Array)return n;let e=Ph(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Qa={DEG2RAD:pa,RAD2DEG:Ao,generateUUID:ir,clamp:ce,euclideanModulo:Kd,mapLinear:Sv,inverseLerp:Mv,lerp:ma,damp:bv,pingpong:wv,smoothstep:Ev,smootherstep:Tv,randInt:Av,randFloat:Rv,randFloatSpread:Cv,seededRandom:Pv,degToRad:Iv,radToDeg:Lv,isPowerOfTwo:Dv,ceilPowerOfTwo:Nv,floorPowerOfTwo:Qd,setQuaternionFromProperEuler:Uv,normalize:ef,denormalize:tf},af=class af{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};af.prototype.isVector2=!0;var Kt=af,Kn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],m=r[o+1],g=r[o+2],x=r[o+3];if(d!==x||c!==u||l!==m||h!==g){let p=c*u+l*m+h*g+d*x;p<0&&(u=-u,m=-m,g=-g,x=-x,p=-p);let f=1-a;if(p<.9995){let M=Math.acos(p),P=Math.sin(M);f=Math.sin(f*M)/P,a=Math.sin(a*M)/P,c=c*f+u*a,l=l*f+m*a,h=h*f+g*a,d=d*f+x*a}else{c=c*f+u*a,l=l*f+m*a,h=h*f+g*a,d=d*f+x*a;let M=1/Math.sqrt(c*c+l*l+h*h+d*d);c*=M,l*=M,h*=M,d*=M}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],h=i[s+3],d=r[o],u=r[o+1],m=r[o+2],g=r[o+3];return t[e]=a*g+h*d+c*m-l*u,t[e+1]=c*g+h*u+l*d-a*m,t[e+2]=l*g+h*m+a*u-c*d,t[e+3]=h*g-a*d-c*u-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(s/2),d=a(r/2),u=c(i/2),m=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=u*h*d+l*m*g,this._y=l*m*d-u*h*g,this._z=l*h*g+u*m*d,this._w=l*h*d-u*m*g;break;case"YXZ":this._x=u*h*d+l*m*g,this._y=l*m*d-u*h*g,this._z=l*h*g-u*m*d,this._w=l*h*d+u*m*g;break;case"ZXY":this._x=u*h*d-l*m*g,this._y=l*m*d+u*h*g,this._z=l*h*g+u*m*d,this._w=l*h*d-u*m*g;break;case"ZYX":this._x=u*h*d-l*m*g,this._y=l*m*d+u*h*g,this._z=l*h*g-u*m*d,this._w=l*h*d+u*m*g;break;case"YZX":this._x=u*h*d+l*m*g,this._y=l*m*d+u*h*g,this._z=l*h*g-u*m*d,this._w=l*h*d-u*m*g;break;case"XZY":this._x=u*h*d-l*m*g,this._y=l*m*d-u*h*g,this._z=l*h*g+u*m*d,this._w=l*h*d+u*m*g;break;default:Jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],d=e[10],u=i+a+d;if(u>0){let m=.5/Math.sqrt(u+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(o-s)*m}else if(i>a&&i>d){let m=2*Math.sqrt(1+i-a-d);this._w=(h-c)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+l)/m}else if(a>d){let m=2*Math.sqrt(1+a-i-d);this._w=(r-l)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+d-i-a);this._w=(o-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=i*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-s*a,this._w=o*h-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},lf=class lf{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ug.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ug.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),h=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+c*l+o*d-a*h,this.y=i+c*h+a*l-r*d,this.z=s+c*d+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ju.copy(this).projectOnVector(t),this.sub(Ju)}reflect(t){return this.sub(Ju.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};lf.prototype.isVector3=!0;var q=lf,Ju=new q,ug=new Kn,cf=class cf{constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],d=i[7],u=i[2],m=i[5],g=i[8],x=s[0],p=s[3],f=s[6],M=s[1],P=s[4],S=s[7],C=s[2],E=s[5],_=s[8];return r[0]=o*x+a*M+c*C,r[3]=o*p+a*P+c*E,r[6]=o*f+a*S+c*_,r[1]=l*x+h*M+d*C,r[4]=l*p+h*P+d*E,r[7]=l*f+h*S+d*_,r[2]=u*x+m*M+g*C,r[5]=u*p+m*P+g*E,r[8]=u*f+m*S+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-i*r*h+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=h*o-a*l,u=a*c-h*r,m=l*r-o*c,g=e*d+i*u+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=d*x,t[1]=(s*l-h*i)*x,t[2]=(a*i-s*o)*x,t[3]=u*x,t[4]=(h*e-s*c)*x,t[5]=(s*r-a*e)*x,t[6]=m*x,t[7]=(i*c-l*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return fa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ju.makeScale(t,e)),this}rotate(t){return fa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ju.makeRotation(-t)),this}translate(t,e){return fa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ju.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};cf.prototype.isMatrix3=!0;var re=cf,ju=new re,dg=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),fg=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Fv(){let n={enabled:!0,workingColorSpace:_a,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ie&&(s.r=Ss(s.r),s.g=Ss(s.g),s.b=Ss(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ie&&(s.r=bo(s.r),s.g=bo(s.g),s.b=bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===As?xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[_a]:{primaries:t,whitePoint:i,transfer:xa,toXYZ:dg,fromXYZ:fg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:$n},outputColorSpaceConfig:{drawingBufferColorSpace:$n}},[$n]:{primaries:t,whitePoint:i,transfer:Ie,toXYZ:dg,fromXYZ:fg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:$n}}}),n}var ve=Fv();function Ss(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function bo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ao,_c=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ao===void 0&&(ao=ya("canvas")),ao.width=t.width,ao.height=t.height;let s=ao.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ao}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ya("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ss(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ss(e[i]/255)*255):e[i]=Ss(e[i]);return{data:e,width:t.width,height:t.height}}else return Jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ov=0,Ro=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ov++}),this.uuid=ir(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ku(s[o].image)):r.push(Ku(s[o]))}else r=Ku(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ku(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?_c.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Jt("Texture: Unable to serialize Texture."),{})}var Bv=0,Qu=new q,Qn=class n extends Oi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ts,s=ts,r=jn,o=Es,a=Hi,c=si,l=n.DEFAULT_ANISOTROPY,h=As){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Bv++}),this.uuid=ir(),this.name="",this.source=new Ro(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Qu).x}get height(){return this.source.getSize(Qu).y}get depth(){return this.source.getSize(Qu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==zd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case pc:t.x=t.x-Math.floor(t.x);break;case ts:t.x=t.x<0?0:1;break;case mc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case pc:t.y=t.y-Math.floor(t.y);break;case ts:t.y=t.y<0?0:1;break;case mc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=zd;Qn.DEFAULT_ANISOTROPY=1;var hf=class hf{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],h=c[4],d=c[8],u=c[1],m=c[5],g=c[9],x=c[2],p=c[6],f=c[10];if(Math.abs(h-u)<.01&&Math.abs(d-x)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+x)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let P=(l+1)/2,S=(m+1)/2,C=(f+1)/2,E=(h+u)/4,_=(d+x)/4,v=(g+p)/4;return P>S&&P>C?P<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(P),s=E/i,r=_/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=E/s,r=v/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=v/r),this.set(i,s,r,e),this}let M=Math.sqrt((p-g)*(p-g)+(d-x)*(d-x)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(p-g)/M,this.y=(d-x)/M,this.z=(u-h)/M,this.w=Math.acos((l+m+f-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};hf.prototype.isVector4=!0;var Le=hf,xc=class extends Oi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Le(0,0,t,e),this.scissorTest=!1,this.viewport=new Le(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ro(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends xc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Sa=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pn,this.minFilter=pn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var yc=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pn,this.minFilter=pn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Hc=class Hc{constructor(t,e,i,s,r,o,a,c,l,h,d,u,m,g,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,h,d,u,m,g,x,p)}set(t,e,i,s,r,o,a,c,l,h,d,u,m,g,x,p){let f=this.elements;return f[0]=t,f[4]=e,f[8]=i,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=c,f[2]=l,f[6]=h,f[10]=d,f[14]=u,f[3]=m,f[7]=g,f[11]=x,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Hc().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/lo.setFromMatrixColumn(t,0).length(),r=1/lo.setFromMatrixColumn(t,1).length(),o=1/lo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,m=o*d,g=a*h,x=a*d;e[0]=c*h,e[4]=-c*d,e[8]=l,e[1]=m+g*l,e[5]=u-x*l,e[9]=-a*c,e[2]=x-u*l,e[6]=g+m*l,e[10]=o*c}else if(t.order==="YXZ"){let u=c*h,m=c*d,g=l*h,x=l*d;e[0]=u+x*a,e[4]=g*a-m,e[8]=o*l,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=m*a-g,e[6]=x+u*a,e[10]=o*c}else if(t.order==="ZXY"){let u=c*h,m=c*d,g=l*h,x=l*d;e[0]=u-x*a,e[4]=-o*d,e[8]=g+m*a,e[1]=m+g*a,e[5]=o*h,e[9]=x-u*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let u=o*h,m=o*d,g=a*h,x=a*d;e[0]=c*h,e[4]=g*l-m,e[8]=u*l+x,e[1]=c*d,e[5]=x*l+u,e[9]=m*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let u=o*c,m=o*l,g=a*c,x=a*l;e[0]=c*h,e[4]=x-u*d,e[8]=g*d+m,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=m*d+g,e[10]=u-x*d}else if(t.order==="XZY"){let u=o*c,m=o*l,g=a*c,x=a*l;e[0]=c*h,e[4]=-d,e[8]=l*h,e[1]=u*d+x,e[5]=o*h,e[9]=m*d-g,e[2]=g*d-m,e[6]=a*h,e[10]=x*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(zv,t,kv)}lookAt(t,e,i){let s=this.elements;return fi.subVectors(t,e),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),Vs.crossVectors(i,fi),Vs.lengthSq()===0&&(Math.abs(i.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),Vs.crossVectors(i,fi)),Vs.normalize(),Fl.crossVectors(fi,Vs),s[0]=Vs.x,s[4]=Fl.x,s[8]=fi.x,s[1]=Vs.y,s[5]=Fl.y,s[9]=fi.y,s[2]=Vs.z,s[6]=Fl.z,s[10]=fi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],d=i[5],u=i[9],m=i[13],g=i[2],x=i[6],p=i[10],f=i[14],M=i[3],P=i[7],S=i[11],C=i[15],E=s[0],_=s[4],v=s[8],L=s[12],T=s[1],b=s[5],D=s[9],F=s[13],I=s[2],O=s[6],H=s[10],z=s[14],Q=s[3],Y=s[7],Z=s[11],nt=s[15];return r[0]=o*E+a*T+c*I+l*Q,r[4]=o*_+a*b+c*O+l*Y,r[8]=o*v+a*D+c*H+l*Z,r[12]=o*L+a*F+c*z+l*nt,r[1]=h*E+d*T+u*I+m*Q,r[5]=h*_+d*b+u*O+m*Y,r[9]=h*v+d*D+u*H+m*Z,r[13]=h*L+d*F+u*z+m*nt,r[2]=g*E+x*T+p*I+f*Q,r[6]=g*_+x*b+p*O+f*Y,r[10]=g*v+x*D+p*H+f*Z,r[14]=g*L+x*F+p*z+f*nt,r[3]=M*E+P*T+S*I+C*Q,r[7]=M*_+P*b+S*O+C*Y,r[11]=M*v+P*D+S*H+C*Z,r[15]=M*L+P*F+S*z+C*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],d=t[6],u=t[10],m=t[14],g=t[3],x=t[7],p=t[11],f=t[15],M=c*m-l*u,P=a*m-l*d,S=a*u-c*d,C=o*m-l*h,E=o*u-c*h,_=o*d-a*h;return e*(x*M-p*P+f*S)-i*(g*M-p*C+f*E)+s*(g*P-x*C+f*_)-r*(g*S-x*E+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-i*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],d=t[9],u=t[10],m=t[11],g=t[12],x=t[13],p=t[14],f=t[15],M=e*a-i*o,P=e*c-s*o,S=e*l-r*o,C=i*c-s*a,E=i*l-r*a,_=s*l-r*c,v=h*x-d*g,L=h*p-u*g,T=h*f-m*g,b=d*p-u*x,D=d*f-m*x,F=u*f-m*p,I=M*F-P*D+S*b+C*T-E*L+_*v;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/I;return t[0]=(a*F-c*D+l*b)*O,t[1]=(s*D-i*F-r*b)*O,t[2]=(x*_-p*E+f*C)*O,t[3]=(u*E-d*_-m*C)*O,t[4]=(c*T-o*F-l*L)*O,t[5]=(e*F-s*T+r*L)*O,t[6]=(p*S-g*_-f*P)*O,t[7]=(h*_-u*S+m*P)*O,t[8]=(o*D-a*T+l*v)*O,t[9]=(i*T-e*D-r*v)*O,t[10]=(g*E-x*S+f*M)*O,t[11]=(d*S-h*E-m*M)*O,t[12]=(a*L-o*b-c*v)*O,t[13]=(e*b-i*L+s*v)*O,t[14]=(x*P-g*C-p*M)*O,t[15]=(h*C-d*P+u*M)*O,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+i,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,d=a+a,u=r*l,m=r*h,g=r*d,x=o*h,p=o*d,f=a*d,M=c*l,P=c*h,S=c*d,C=i.x,E=i.y,_=i.z;return s[0]=(1-(x+f))*C,s[1]=(m+S)*C,s[2]=(g-P)*C,s[3]=0,s[4]=(m-S)*E,s[5]=(1-(u+f))*E,s[6]=(p+M)*E,s[7]=0,s[8]=(g+P)*_,s[9]=(p-M)*_,s[10]=(1-(u+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=lo.set(s[0],s[1],s[2]).length(),a=lo.set(s[4],s[5],s[6]).length(),c=lo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let l=1/o,h=1/a,d=1/c;return Di.elements[0]*=l,Di.elements[1]*=l,Di.elements[2]*=l,Di.elements[4]*=h,Di.elements[5]*=h,Di.elements[6]*=h,Di.elements[8]*=d,Di.elements[9]*=d,Di.elements[10]*=d,e.setFromRotationMatrix(Di),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=wi,c=!1){let l=this.elements,h=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),m=(i+s)/(i-s),g,x;if(c)g=r/(o-r),x=o*r/(o-r);else if(a===wi)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Eo)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=d,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=wi,c=!1){let l=this.elements,h=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),m=-(i+s)/(i-s),g,x;if(c)g=1/(o-r),x=o/(o-r);else if(a===wi)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===Eo)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=u,l[1]=0,l[5]=d,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};Hc.prototype.isMatrix4=!0;var Fe=Hc,lo=new q,Di=new Fe,zv=new q(0,0,0),kv=new q(1,1,1),Vs=new q,Fl=new q,fi=new q,pg=new Fe,mg=new Kn,bs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],d=s[2],u=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ce(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ce(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return pg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(pg,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return mg.setFromEuler(this),this.setFromQuaternion(mg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};bs.DEFAULT_ORDER="XYZ";var Ma=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Vv=0,gg=new q,co=new Kn,gs=new Fe,Ol=new q,la=new q,Gv=new q,Hv=new Kn,_g=new q(1,0,0),xg=new q(0,1,0),yg=new q(0,0,1),vg={type:"added"},Wv={type:"removed"},ho={type:"childadded",child:null},td={type:"childremoved",child:null},In=class n extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Vv++}),this.uuid=ir(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new q,e=new bs,i=new Kn,s=new q(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Fe},normalMatrix:{value:new re}}),this.matrix=new Fe,this.matrixWorld=new Fe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ma,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return co.setFromAxisAngle(t,e),this.quaternion.multiply(co),this}rotateOnWorldAxis(t,e){return co.setFromAxisAngle(t,e),this.quaternion.premultiply(co),this}rotateX(t){return this.rotateOnAxis(_g,t)}rotateY(t){return this.rotateOnAxis(xg,t)}rotateZ(t){return this.rotateOnAxis(yg,t)}translateOnAxis(t,e){return gg.copy(t).applyQuaternion(this.quaternion),this.position.add(gg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(_g,t)}translateY(t){return this.translateOnAxis(xg,t)}translateZ(t){return this.translateOnAxis(yg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ol.copy(t):Ol.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),la.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gs.lookAt(la,Ol,this.up):gs.lookAt(Ol,la,this.up),this.quaternion.setFromRotationMatrix(gs),s&&(gs.extractRotation(s.matrixWorld),co.setFromRotationMatrix(gs),this.quaternion.premultiply(co.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(vg),ho.child=t,this.dispatchEvent(ho),ho.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Wv),td.child=t,this.dispatchEvent(td),td.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gs.multiply(t.parent.matrixWorld)),t.applyMatrix4(gs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(vg),ho.child=t,this.dispatchEvent(ho),ho.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(la,t,Gv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(la,Hv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let d=c[l];r(t.shapes,d)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),m=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),m.length>0&&(i.animations=m),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};In.DEFAULT_UP=new q(0,1,0);In.DEFAULT_MATRIX_AUTO_UPDATE=!0;In.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jn=class extends In{constructor(){super(),this.isGroup=!0,this.type="Group"}},Xv={type:"move"},Co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let x of t.hand.values()){let p=e.getJointPose(x,i),f=this._getHandJoint(l,x);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}let h=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],u=h.position.distanceTo(d.position),m=.02,g=.005;l.inputState.pinching&&u>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&u<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Xv)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Jn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},M0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gs={h:0,s:0,l:0},Bl={h:0,s:0,l:0};function ed(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var he=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=$n){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=Kd(t,1),e=ce(e,0,1),i=ce(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ed(o,r,t+1/3),this.g=ed(o,r,t),this.b=ed(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=$n){function i(r){r!==void 0&&parseFloat(r)<1&&Jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=$n){let i=M0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ss(t.r),this.g=Ss(t.g),this.b=Ss(t.b),this}copyLinearToSRGB(t){return this.r=bo(t.r),this.g=bo(t.g),this.b=bo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=$n){return ve.workingToColorSpace(Bn.copy(this),t),Math.round(ce(Bn.r*255,0,255))*65536+Math.round(ce(Bn.g*255,0,255))*256+Math.round(ce(Bn.b*255,0,255))}getHexString(t=$n){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(Bn.copy(this),e);let i=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=h<=.5?d/(o+a):d/(2-o-a),o){case i:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-i)/d+2;break;case r:c=(i-s)/d+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(Bn.copy(this),e),t.r=Bn.r,t.g=Bn.g,t.b=Bn.b,t}getStyle(t=$n){ve.workingToColorSpace(Bn.copy(this),t);let e=Bn.r,i=Bn.g,s=Bn.b;return t!==$n?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Gs),this.setHSL(Gs.h+t,Gs.s+e,Gs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Gs),t.getHSL(Bl);let i=ma(Gs.h,Bl.h,e),s=ma(Gs.s,Bl.s,e),r=ma(Gs.l,Bl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new he;he.NAMES=M0;var ba=class extends In{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new bs,this.environmentIntensity=1,this.environmentRotation=new bs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ni=new q,_s=new q,nd=new q,xs=new q,uo=new q,fo=new q,Sg=new q,id=new q,sd=new q,rd=new q,od=new Le,ad=new Le,ld=new Le,qs=class n{constructor(t=new q,e=new q,i=new q){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ni.subVectors(t,e),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ni.subVectors(s,e),_s.subVectors(i,e),nd.subVectors(t,e);let o=Ni.dot(Ni),a=Ni.dot(_s),c=Ni.dot(nd),l=_s.dot(_s),h=_s.dot(nd),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,m=(l*c-a*h)*u,g=(o*h-a*c)*u;return r.set(1-m-g,g,m)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,xs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,xs.x),c.addScaledVector(o,xs.y),c.addScaledVector(a,xs.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return od.setScalar(0),ad.setScalar(0),ld.setScalar(0),od.fromBufferAttribute(t,e),ad.fromBufferAttribute(t,i),ld.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(od,r.x),o.addScaledVector(ad,r.y),o.addScaledVector(ld,r.z),o}static isFrontFacing(t,e,i,s){return Ni.subVectors(i,e),_s.subVectors(t,e),Ni.cross(_s).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ni.subVectors(this.c,this.b),_s.subVectors(this.a,this.b),Ni.cross(_s).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;uo.subVectors(s,i),fo.subVectors(r,i),id.subVectors(t,i);let c=uo.dot(id),l=fo.dot(id);if(c<=0&&l<=0)return e.copy(i);sd.subVectors(t,s);let h=uo.dot(sd),d=fo.dot(sd);if(h>=0&&d<=h)return e.copy(s);let u=c*d-h*l;if(u<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(i).addScaledVector(uo,o);rd.subVectors(t,r);let m=uo.dot(rd),g=fo.dot(rd);if(g>=0&&m<=g)return e.copy(r);let x=m*l-c*g;if(x<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(i).addScaledVector(fo,a);let p=h*g-m*d;if(p<=0&&d-h>=0&&m-g>=0)return Sg.subVectors(r,s),a=(d-h)/(d-h+(m-g)),e.copy(s).addScaledVector(Sg,a);let f=1/(p+x+u);return o=x*f,a=u*f,e.copy(i).addScaledVector(uo,o).addScaledVector(fo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},_i=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ui.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ui.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ui.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ui):Ui.fromBufferAttribute(r,o),Ui.applyMatrix4(t.matrixWorld),this.expandByPoint(Ui);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),zl.copy(i.boundingBox)),zl.applyMatrix4(t.matrixWorld),this.union(zl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ui),Ui.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ca),kl.subVectors(this.max,ca),po.subVectors(t.a,ca),mo.subVectors(t.b,ca),go.subVectors(t.c,ca),Hs.subVectors(mo,po),Ws.subVectors(go,mo),Mr.subVectors(po,go);let e=[0,-Hs.z,Hs.y,0,-Ws.z,Ws.y,0,-Mr.z,Mr.y,Hs.z,0,-Hs.x,Ws.z,0,-Ws.x,Mr.z,0,-Mr.x,-Hs.y,Hs.x,0,-Ws.y,Ws.x,0,-Mr.y,Mr.x,0];return!cd(e,po,mo,go,kl)||(e=[1,0,0,0,1,0,0,0,1],!cd(e,po,mo,go,kl))?!1:(Vl.crossVectors(Hs,Ws),e=[Vl.x,Vl.y,Vl.z],cd(e,po,mo,go,kl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ui).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ui).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ys[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ys[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ys[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ys[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ys[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ys[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ys[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ys[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ys),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ys=[new q,new q,new q,new q,new q,new q,new q,new q],Ui=new q,zl=new _i,po=new q,mo=new q,go=new q,Hs=new q,Ws=new q,Mr=new q,ca=new q,kl=new q,Vl=new q,br=new q;function cd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){br.fromArray(n,r);let a=s.x*Math.abs(br.x)+s.y*Math.abs(br.y)+s.z*Math.abs(br.z),c=t.dot(br),l=e.dot(br),h=i.dot(br);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var fn=new q,Gl=new Kt,qv=0,Fi=class extends Oi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:qv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Jd,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=t!==void 0?Ph(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Gl.fromBufferAttribute(this,e),Gl.applyMatrix3(t),this.setXY(e,Gl.x,Gl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix3(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):tf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):ef(t,this.array)}};var wa=class extends Fi{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ea=class extends Fi{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ve=class extends Fi{constructor(t,e,i){super(new Float32Array(t),e,i)}},Yv=new _i,ha=new q,hd=new q,Bi=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Yv.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ha.subVectors(t,this.center);let e=ha.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ha,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(hd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ha.copy(t.center).add(hd)),this.expandByPoint(ha.copy(t.center).sub(hd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},$v=0,bi=new Fe,ud=new In,_o=new q,pi=new _i,ua=new _i,An=new q,ii=class n extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$v++}),this.uuid=ir(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(yv(t)?Ea:wa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new re().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return bi.makeRotationFromQuaternion(t),this.applyMatrix4(bi),this}rotateX(t){return bi.makeRotationX(t),this.applyMatrix4(bi),this}rotateY(t){return bi.makeRotationY(t),this.applyMatrix4(bi),this}rotateZ(t){return bi.makeRotationZ(t),this.applyMatrix4(bi),this}translate(t,e,i){return bi.makeTranslation(t,e,i),this.applyMatrix4(bi),this}scale(t,e,i){return bi.makeScale(t,e,i),this.applyMatrix4(bi),this}lookAt(t){return ud.lookAt(t),ud.updateMatrix(),this.applyMatrix4(ud.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_o).negate(),this.translate(_o.x,_o.y,_o.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ve(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _i);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ua.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(pi.min,ua.min),pi.expandByPoint(An),An.addVectors(pi.max,ua.max),pi.expandByPoint(An)):(pi.expandByPoint(ua.min),pi.expandByPoint(ua.max))}pi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)An.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(An));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)An.fromBufferAttribute(a,l),c&&(_o.fromBufferAttribute(t,l),An.add(_o)),s=Math.max(s,i.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Fi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new q,c[L]=new q;let h=new q,d=new q,u=new q,m=new Kt,g=new Kt,x=new Kt,p=new q,f=new q;function M(L,T,b){l[L]=l[T]=l[b]=1,h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,T),u.fromBufferAttribute(i,b),m.fromBufferAttribute(r,L),g.fromBufferAttribute(r,T),x.fromBufferAttribute(r,b),d.sub(h),u.sub(h),g.sub(m),x.sub(m);let D=1/(g.x*x.y-x.x*g.y);isFinite(D)&&(p.copy(d).multiplyScalar(x.y).addScaledVector(u,-g.y).multiplyScalar(D),f.copy(u).multiplyScalar(g.x).addScaledVector(d,-x.x).multiplyScalar(D),a[L].add(p),a[T].add(p),a[b].add(p),c[L].add(f),c[T].add(f),c[b].add(f))}let P=this.groups;P.length===0&&(P=[{start:0,count:t.count}]);for(let L=0,T=P.length;L<T;++L){let b=P[L],D=b.start,F=b.count;for(let I=D,O=D+F;I<O;I+=3)M(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let S=new q,C=new q,E=new q,_=new q;function v(L){E.fromBufferAttribute(s,L),_.copy(E);let T=a[L];S.copy(T),S.sub(E.multiplyScalar(E.dot(T))).normalize(),C.crossVectors(_,T);let D=C.dot(c[L])<0?-1:1;o.setXYZW(L,S.x,S.y,S.z,D)}for(let L=0,T=i.count;L<T;++L)l[L]&&v(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Fi(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,m=i.count;u<m;u++)i.setXYZ(u,0,0,0);let s=new q,r=new q,o=new q,a=new q,c=new q,l=new q,h=new q,d=new q;if(t)for(let u=0,m=t.count;u<m;u+=3){let g=t.getX(u+0),x=t.getX(u+1),p=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,x),l.fromBufferAttribute(i,p),a.add(h),c.add(h),l.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let u=0,m=e.count;u<m;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)An.fromBufferAttribute(t,e),An.normalize(),t.setXYZ(e,An.x,An.y,An.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,d=a.normalized,u=new l.constructor(c.length*h),m=0,g=0;for(let x=0,p=c.length;x<p;x++){a.isInterleavedBufferAttribute?m=c[x]*a.data.stride+a.offset:m=c[x]*h;for(let f=0;f<h;f++)u[g++]=l[m++]}return new Fi(u,h,d)}if(this.index===null)return Jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,d=l.length;h<d;h++){let u=l[h],m=t(u,i);c.push(m)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let d=0,u=l.length;d<u;d++){let m=l[d];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],d=r[l];for(let u=0,m=d.length;u<m;u++)h.push(d[u].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},vc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Jd,this.updateRanges=[],this.version=0,this.uuid=ir()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Mg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Mg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Mg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=ir()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Yn=new q,zi=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Ph(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){va("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Fi(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){va("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):tf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):ef(t,this.data.array)}},dd=new q,Zv=new q,Jv=new re,mi=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=dd.subVectors(i,e).cross(Zv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(dd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Jv.getNormalMatrix(t),s=this.coplanarPoint(dd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},jv=0,es=class extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:jv++}),this.uuid=ir(),this.name="",this.type="Material",this.blending=Uo,this.side=er,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Cd,this.blendDst=Pd,this.blendEquation=Cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=wo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=d0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oc,this.stencilZFail=oc,this.stencilZPass=oc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new mi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Kt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var vs=new q,fd=new q,Hl=new q,Wl=new q,Tr=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,vs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=vs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(vs.copy(this.origin).addScaledVector(this.direction,e),vs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){fd.copy(t).add(e).multiplyScalar(.5),Hl.copy(e).sub(t).normalize(),Wl.copy(this.origin).sub(fd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Hl),a=Wl.dot(this.direction),c=-Wl.dot(Hl),l=Wl.lengthSq(),h=Math.abs(1-o*o),d,u,m,g;if(h>0)if(d=o*c-a,u=o*a-c,g=r*h,d>=0)if(u>=-g)if(u<=g){let x=1/h;d*=x,u*=x,m=d*(d+o*u+2*a)+u*(o*d+u+2*c)+l}else u=r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*c)+l;else u=-r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*c)+l;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-c),r),m=-d*d+u*(u+2*c)+l):u<=g?(d=0,u=Math.min(Math.max(-r,-c),r),m=u*(u+2*c)+l):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-c),r),m=-d*d+u*(u+2*c)+l);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(fd).addScaledVector(Hl,u),m}intersectSphere(t,e){if(t.radius<0)return null;vs.subVectors(t.center,this.origin);let i=vs.dot(this.direction),s=vs.dot(vs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return l>=0?(i=(t.min.x-u.x)*l,s=(t.max.x-u.x)*l):(i=(t.max.x-u.x)*l,s=(t.min.x-u.x)*l),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,c=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,c=(t.min.z-u.z)*d),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,vs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,m=t.z-o.z,g=e.x-o.x,x=e.y-o.y,p=e.z-o.z,f=i.x-o.x,M=i.y-o.y,P=i.z-o.z,S=Math.abs(c),C=Math.abs(l),E=Math.abs(h),_,v,L,T,b,D,F,I,O,H,z,Q;if(S>=C&&S>=E?(L=c,D=d,O=g,Q=f,c>=0?(_=l,v=h,T=u,b=m,F=x,I=p,H=M,z=P):(_=h,v=l,T=m,b=u,F=p,I=x,H=P,z=M)):C>=E?(L=l,D=u,O=x,Q=M,l>=0?(_=h,v=c,T=m,b=d,F=p,I=g,H=P,z=f):(_=c,v=h,T=d,b=m,F=g,I=p,H=f,z=P)):(L=h,D=m,O=p,Q=P,h>=0?(_=c,v=l,T=d,b=u,F=g,I=x,H=f,z=M):(_=l,v=c,T=u,b=d,F=x,I=g,H=M,z=f)),L===0)return null;let Y=_/L,Z=v/L,nt=1/L,lt=T-Y*D,ht=b-Z*D,tt=F-Y*O,mt=I-Z*O,_t=H-Y*Q,ot=z-Z*Q,dt=_t*mt-ot*tt,Nt=lt*ot-ht*_t,$t=tt*ht-mt*lt;if(s){if(dt<0||Nt<0||$t<0)return null}else if((dt<0||Nt<0||$t<0)&&(dt>0||Nt>0||$t>0))return null;let Ot=dt+Nt+$t;if(Ot===0)return null;let se=nt*(dt*D+Nt*O+$t*Q);return(Ot>0?se<0:se>0)?null:this.at(se/Ot,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Sc=class extends es{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new bs,this.combine=Id,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},bg=new Fe,wr=new Tr,Xl=new Bi,wg=new q,ql=new q,Yl=new q,$l=new q,pd=new q,Zl=new q,Eg=new q,Jl=new q,zn=class extends In{constructor(t=new ii,e=new Sc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Zl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],d=r[c];h!==0&&(pd.fromBufferAttribute(d,t),o?Zl.addScaledVector(pd,h):Zl.addScaledVector(pd.sub(e),h))}e.add(Zl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Xl.copy(i.boundingSphere),Xl.applyMatrix4(r),wr.copy(t.ray).recast(t.near),!(Xl.containsPoint(wr.origin)===!1&&(wr.intersectSphere(Xl,wg)===null||wr.origin.distanceToSquared(wg)>(t.far-t.near)**2))&&(bg.copy(r).invert(),wr.copy(t.ray).applyMatrix4(bg),!(i.boundingBox!==null&&wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,wr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let p=u[g],f=o[p.materialIndex],M=Math.max(p.start,m.start),P=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let S=M,C=P;S<C;S+=3){let E=a.getX(S),_=a.getX(S+1),v=a.getX(S+2);s=jl(this,f,t,i,l,h,d,E,_,v),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(a.count,m.start+m.count);for(let p=g,f=x;p<f;p+=3){let M=a.getX(p),P=a.getX(p+1),S=a.getX(p+2);s=jl(this,o,t,i,l,h,d,M,P,S),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let p=u[g],f=o[p.materialIndex],M=Math.max(p.start,m.start),P=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let S=M,C=P;S<C;S+=3){let E=S,_=S+1,v=S+2;s=jl(this,f,t,i,l,h,d,E,_,v),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(c.count,m.start+m.count);for(let p=g,f=x;p<f;p+=3){let M=p,P=p+1,S=p+2;s=jl(this,o,t,i,l,h,d,M,P,S),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Kv(n,t,e,i,s,r,o,a){let c;if(t.side===ti?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===er,a),c===null)return null;Jl.copy(a),Jl.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Jl);return l<e.near||l>e.far?null:{distance:l,point:Jl.clone(),object:n}}function jl(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,ql),n.getVertexPosition(c,Yl),n.getVertexPosition(l,$l);let h=Kv(n,t,e,i,ql,Yl,$l,Eg);if(h){let d=new q;qs.getBarycoord(Eg,ql,Yl,$l,d),s&&(h.uv=qs.getInterpolatedAttribute(s,a,c,l,d,new Kt)),r&&(h.uv1=qs.getInterpolatedAttribute(r,a,c,l,d,new Kt)),o&&(h.normal=qs.getInterpolatedAttribute(o,a,c,l,d,new q),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:c,c:l,normal:new q,materialIndex:0};qs.getNormal(ql,Yl,$l,u.normal),h.face=u,h.barycoord=d}return h}var Mc=class extends Qn{constructor(t=null,e=1,i=1,s,r,o,a,c,l=pn,h=pn,d,u){super(null,o,a,c,l,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Er=new Bi,Qv=new Kt(.5,.5),Kl=new q,Ys=class{constructor(t=new mi,e=new mi,i=new mi,s=new mi,r=new mi,o=new mi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=wi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],d=r[5],u=r[6],m=r[7],g=r[8],x=r[9],p=r[10],f=r[11],M=r[12],P=r[13],S=r[14],C=r[15];if(s[0].setComponents(l-o,m-h,f-g,C-M).normalize(),s[1].setComponents(l+o,m+h,f+g,C+M).normalize(),s[2].setComponents(l+a,m+d,f+x,C+P).normalize(),s[3].setComponents(l-a,m-d,f-x,C-P).normalize(),i)s[4].setComponents(c,u,p,S).normalize(),s[5].setComponents(l-c,m-u,f-p,C-S).normalize();else if(s[4].setComponents(l-c,m-u,f-p,C-S).normalize(),e===wi)s[5].setComponents(l+c,m+u,f+p,C+S).normalize();else if(e===Eo)s[5].setComponents(c,u,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Er.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Er.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Er)}intersectsSprite(t){Er.center.set(0,0,0);let e=Qv.distanceTo(t.center);return Er.radius=.7071067811865476+e,Er.applyMatrix4(t.matrixWorld),this.intersectsSphere(Er)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Kl.x=s.normal.x>0?t.max.x:t.min.x,Kl.y=s.normal.y>0?t.max.y:t.min.y,Kl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Kl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Tg=new Fe,bc=class n{constructor(){this.coordinateSystem=wi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Tg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ys),i[s].setFromProjectionMatrix(Tg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ys),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Ta=class extends es{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},wc=new q,Ec=new q,Ag=new Fe,da=new Tr,Ql=new Bi,md=new q,Rg=new q,Tc=class extends In{constructor(t=new ii,e=new Ta){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)wc.fromBufferAttribute(e,s-1),Ec.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=wc.distanceTo(Ec);t.setAttribute("lineDistance",new Ve(i,1))}else Jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ql.copy(i.boundingSphere),Ql.applyMatrix4(s),Ql.radius+=r,t.ray.intersectsSphere(Ql)===!1)return;Ag.copy(s).invert(),da.copy(t.ray).applyMatrix4(Ag);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=m,p=g-1;x<p;x+=l){let f=h.getX(x),M=h.getX(x+1),P=tc(this,t,da,c,f,M,x);P&&e.push(P)}if(this.isLineLoop){let x=h.getX(g-1),p=h.getX(m),f=tc(this,t,da,c,x,p,g-1);f&&e.push(f)}}else{let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=m,p=g-1;x<p;x+=l){let f=tc(this,t,da,c,x,x+1,x);f&&e.push(f)}if(this.isLineLoop){let x=tc(this,t,da,c,g-1,m,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function tc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(wc.fromBufferAttribute(a,s),Ec.fromBufferAttribute(a,r),e.distanceSqToSegment(wc,Ec,md,Rg)>i)return;md.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(md);if(!(l<t.near||l>t.far))return{distance:l,point:Rg.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Cg=new q,Pg=new q,Ac=class extends Tc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Cg.fromBufferAttribute(e,s),Pg.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Cg.distanceTo(Pg);t.setAttribute("lineDistance",new Ve(i,1))}else Jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Aa=class extends Qn{constructor(t=[],e=Pr,i,s,r,o,a,c,l,h){super(t,e,i,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ra=class extends Qn{constructor(t,e,i,s,r,o,a,c,l){super(t,e,i,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ws=class extends Qn{constructor(t,e,i=ki,s,r,o,a=pn,c=pn,l,h=Ms,d=1){if(h!==Ms&&h!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ro(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ca=class extends ws{constructor(t,e=ki,i=Pr,s,r,o=pn,a=pn,c,l=Ms){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Pa=class extends Qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},$s=class n extends ii{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],d=[],u=0,m=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Ve(l,3)),this.setAttribute("normal",new Ve(h,3)),this.setAttribute("uv",new Ve(d,2));function g(x,p,f,M,P,S,C,E,_,v,L){let T=S/_,b=C/v,D=S/2,F=C/2,I=E/2,O=_+1,H=v+1,z=0,Q=0,Y=new q;for(let Z=0;Z<H;Z++){let nt=Z*b-F;for(let lt=0;lt<O;lt++){let ht=lt*T-D;Y[x]=ht*M,Y[p]=nt*P,Y[f]=I,l.push(Y.x,Y.y,Y.z),Y[x]=0,Y[p]=0,Y[f]=E>0?1:-1,h.push(Y.x,Y.y,Y.z),d.push(lt/_),d.push(1-Z/v),z+=1}}for(let Z=0;Z<v;Z++)for(let nt=0;nt<_;nt++){let lt=u+nt+O*Z,ht=u+nt+O*(Z+1),tt=u+(nt+1)+O*(Z+1),mt=u+(nt+1)+O*Z;c.push(lt,ht,mt),c.push(ht,tt,mt),Q+=6}a.addGroup(m,Q,L),m+=Q,u+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Po=class n extends ii{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],m=[],g=0,x=[],p=i/2,f=0;M(),o===!1&&(t>0&&P(!0),e>0&&P(!1)),this.setIndex(h),this.setAttribute("position",new Ve(d,3)),this.setAttribute("normal",new Ve(u,3)),this.setAttribute("uv",new Ve(m,2));function M(){let S=new q,C=new q,E=0,_=(e-t)/i;for(let v=0;v<=r;v++){let L=[],T=v/r,b=T*(e-t)+t;for(let D=0;D<=s;D++){let F=D/s,I=F*c+a,O=Math.sin(I),H=Math.cos(I);C.x=b*O,C.y=-T*i+p,C.z=b*H,d.push(C.x,C.y,C.z),S.set(O,_,H).normalize(),u.push(S.x,S.y,S.z),m.push(F,1-T),L.push(g++)}x.push(L)}for(let v=0;v<s;v++)for(let L=0;L<r;L++){let T=x[L][v],b=x[L+1][v],D=x[L+1][v+1],F=x[L][v+1];(t>0||L!==0)&&(h.push(T,b,F),E+=3),(e>0||L!==r-1)&&(h.push(b,D,F),E+=3)}l.addGroup(f,E,0),f+=E}function P(S){let C=g,E=new Kt,_=new q,v=0,L=S===!0?t:e,T=S===!0?1:-1;for(let D=1;D<=s;D++)d.push(0,p*T,0),u.push(0,T,0),m.push(.5,.5),g++;let b=g;for(let D=0;D<=s;D++){let I=D/s*c+a,O=Math.cos(I),H=Math.sin(I);_.x=L*H,_.y=p*T,_.z=L*O,d.push(_.x,_.y,_.z),u.push(0,T,0),E.x=O*.5+.5,E.y=H*.5*T+.5,m.push(E.x,E.y),g++}for(let D=0;D<s;D++){let F=C+D,I=b+D;S===!0?h.push(I,I+1,F):h.push(I+1,I,F),v+=3}l.addGroup(f,v,S===!0?1:2),f+=v}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ia=class n extends Po{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Ar=class n extends ii{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,h=c+1,d=t/a,u=e/c,m=[],g=[],x=[],p=[];for(let f=0;f<h;f++){let M=f*u-o;for(let P=0;P<l;P++){let S=P*d-r;g.push(S,-M,0),x.push(0,0,1),p.push(P/a),p.push(1-f/c)}}for(let f=0;f<c;f++)for(let M=0;M<a;M++){let P=M+l*f,S=M+l*(f+1),C=M+1+l*(f+1),E=M+1+l*f;m.push(P,S,E),m.push(S,C,E)}this.setIndex(m),this.setAttribute("position",new Ve(g,3)),this.setAttribute("normal",new Ve(x,3)),this.setAttribute("uv",new Ve(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var La=class n extends ii{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],d=new q,u=new q,m=[],g=[],x=[],p=[];for(let f=0;f<=i;f++){let M=[],P=f/i,S=o+P*a,C=t*Math.cos(S),E=Math.sqrt(t*t-C*C),_=0;f===0&&o===0?_=.5/e:f===i&&c===Math.PI&&(_=-.5/e);for(let v=0;v<=e;v++){let L=v/e,T=s+L*r;d.x=-E*Math.cos(T),d.y=C,d.z=E*Math.sin(T),g.push(d.x,d.y,d.z),u.copy(d).normalize(),x.push(u.x,u.y,u.z),p.push(L+_,1-P),M.push(l++)}h.push(M)}for(let f=0;f<i;f++)for(let M=0;M<e;M++){let P=h[f][M+1],S=h[f][M],C=h[f+1][M],E=h[f+1][M+1];(f!==0||o>0)&&m.push(P,S,E),(f!==i-1||c<Math.PI)&&m.push(S,C,E)}this.setIndex(m),this.setAttribute("position",new Ve(g,3)),this.setAttribute("normal",new Ve(x,3)),this.setAttribute("uv",new Ve(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Da=class extends ii{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new q,r=new q;if(t.index!==null){let o=t.attributes.position,a=t.index,c=t.groups;c.length===0&&(c=[{start:0,count:a.count,materialIndex:0}]);for(let l=0,h=c.length;l<h;++l){let d=c[l],u=d.start,m=d.count;for(let g=u,x=u+m;g<x;g+=3)for(let p=0;p<3;p++){let f=a.getX(g+p),M=a.getX(g+(p+1)%3);s.fromBufferAttribute(o,f),r.fromBufferAttribute(o,M),Ig(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,c=o.count/3;a<c;a++)for(let l=0;l<3;l++){let h=3*a+l,d=3*a+(l+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,d),Ig(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ve(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Ig(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}var Na=class extends es{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new he(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function Lr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Lg(s))s.isRenderTargetTexture?(Jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Lg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function kn(n){let t={};for(let e=0;e<n.length;e++){let i=Lr(n[e]);for(let s in i)t[s]=i[s]}return t}function Lg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function tS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function nf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var tl={clone:Lr,merge:kn},eS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ei=class extends es{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eS,this.fragmentShader=nS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Lr(t.uniforms),this.uniformsGroups=tS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new he().setHex(s.value);break;case"v2":this.uniforms[i].value=new Kt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Le().fromArray(s.value);break;case"m3":this.uniforms[i].value=new re().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Fe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Rc=class extends Ei{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Io=class extends es{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ch,this.normalScale=new Kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new bs,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Cc=class extends es{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=h0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Pc=class extends es{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function xo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function ec(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Zs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ic=class extends Zs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:yd,endingEnd:yd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case vd:r=t,a=2*e-i;break;case Sd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case vd:o=t,c=2*i-e;break;case Sd:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,m=this._weightNext,g=(i-e)/(s-e),x=g*g,p=x*g,f=-u*p+2*u*x-u*g,M=(1+u)*p+(-1.5-2*u)*x+(-.5+u)*g+1,P=(-1-m)*p+(1.5+m)*x+.5*g,S=m*p-m*x;for(let C=0;C!==a;++C)r[C]=f*o[h+C]+M*o[l+C]+P*o[c+C]+S*o[d+C];return r}},Lc=class extends Zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(i-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[l+u]*d+o[c+u]*h;return r}},Dc=class extends Zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Nc=class extends Zs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(i-e)/(s-e),x=1-g;for(let p=0;p!==a;++p)r[p]=o[l+p]*x+o[c+p]*g;return r}let u=a*2,m=t-1;for(let g=0;g!==a;++g){let x=o[l+g],p=o[c+g],f=m*u+g*2,M=d[f],P=d[f+1],S=t*u+g*2,C=h[S],E=h[S+1],_=sS(i,e,M,C,s);r[g]=b0(_,x,P,E,p)}return r}};function b0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function iS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function sS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=b0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=iS(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var xi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=xo(e,this.TimeBufferType),this.values=xo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:xo(t.times,Array),values:xo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),ec(t.settings)&&(i.settings={inTangents:xo(t.settings.inTangents,Array),outTangents:xo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ic(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ga:e=this.InterpolantFactoryMethodDiscrete;break;case gc:e=this.InterpolantFactoryMethodLinear;break;case rc:e=this.InterpolantFactoryMethodSmooth;break;case xd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Jt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ga;case this.InterpolantFactoryMethodLinear:return gc;case this.InterpolantFactoryMethodSmooth:return rc;case this.InterpolantFactoryMethodBezier:return xd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;ec(this.settings)&&(Dg(this.settings.inTangents,t),Dg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;ec(this.settings)&&(Ng(this.settings.inTangents,t),Ng(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){ie("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){ie("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&vv(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){ie("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===rc,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let d=a*i,u=d-i,m=d+i;for(let g=0;g!==i;++g){let x=e[d+g];if(x!==e[u+g]||x!==e[m+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let d=a*i,u=o*i;for(let m=0;m!==i;++m)e[u+m]=e[d+m]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,ec(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Dg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Ng(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=gc;var Js=class extends xi{constructor(t,e,i){super(t,e,i)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=ga;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Uc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};Uc.prototype.ValueTypeName="color";var Fc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};Fc.prototype.ValueTypeName="number";var Oc=class extends Zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)Kn.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ua=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Oc(this.times,this.values,this.getValueSize(),t)}};Ua.prototype.ValueTypeName="quaternion";Ua.prototype.InterpolantFactoryMethodSmooth=void 0;var js=class extends xi{constructor(t,e,i){super(t,e,i)}};js.prototype.ValueTypeName="string";js.prototype.ValueBufferType=Array;js.prototype.DefaultInterpolation=ga;js.prototype.InterpolantFactoryMethodLinear=void 0;js.prototype.InterpolantFactoryMethodSmooth=void 0;var Bc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};Bc.prototype.ValueTypeName="vector";var zc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,d){return l.push(h,d),this},this.removeHandler=function(h){let d=l.indexOf(h);return d!==-1&&l.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=l.length;d<u;d+=2){let m=l[d],g=l[d+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},w0=new zc,kc=class{constructor(t){this.manager=t!==void 0?t:w0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};kc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Fa=class extends In{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Oa=class extends Fa{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},gd=new Fe,Ug=new q,Fg=new q,Vc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Kt(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Fe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ys,this._frameExtents=new Kt(1,1),this._viewportCount=1,this._viewports=[new Le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ug.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ug),Fg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Fg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){gd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(gd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Eo||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(gd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},nc=new q,ic=new Kn,Qi=new q,Ba=class extends In{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Fe,this.projectionMatrix=new Fe,this.projectionMatrixInverse=new Fe,this.coordinateSystem=wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(nc,ic,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,Qi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(nc,ic,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xs=new q,Og=new Kt,Bg=new Kt,Zn=class extends Ba{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ao*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(pa*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ao*2*Math.atan(Math.tan(pa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Xs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xs.x,Xs.y).multiplyScalar(-t/Xs.z),Xs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Xs.x,Xs.y).multiplyScalar(-t/Xs.z)}getViewSize(t,e){return this.getViewBounds(t,Og,Bg),e.subVectors(Bg,Og)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(pa*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var za=class extends Ba{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Md=class extends Vc{constructor(){super(new za(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ka=class extends Fa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.target=new In,this.shadow=new Md}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Va=class extends ii{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var yo=-90,vo=1,Lo=class extends In{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(yo,vo,t,e);s.layers=this.layers,this.add(s);let r=new Zn(yo,vo,t,e);r.layers=this.layers,this.add(r);let o=new Zn(yo,vo,t,e);o.layers=this.layers,this.add(o);let a=new Zn(yo,vo,t,e);a.layers=this.layers,this.add(a);let c=new Zn(yo,vo,t,e);c.layers=this.layers,this.add(c);let l=new Zn(yo,vo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===wi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Eo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,m),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Gc=class extends Zn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var sf="\\[\\]\\.:\\/",rS=new RegExp("["+sf+"]","g"),rf="[^"+sf+"]",oS="[^"+sf.replace("\\.","")+"]",aS=/((?:WC+[\/:])*)/.source.replace("WC",rf),lS=/(WCOD+)?/.source.replace("WCOD",oS),cS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rf),hS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rf),uS=new RegExp("^"+aS+lS+cS+hS+"$"),dS=["material","materials","bones","map"],bd=class{constructor(t,e,i){let s=i||$e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},$e=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(rS,"")}static parseTrackName(t){let e=uS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);dS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$e.Composite=bd;$e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$e.prototype.GetterByBindingType=[$e.prototype._getValue_direct,$e.prototype._getValue_array,$e.prototype._getValue_arrayElement,$e.prototype._getValue_toArray];$e.prototype.SetterByBindingTypeAndVersioning=[[$e.prototype._setValue_direct,$e.prototype._setValue_direct_setNeedsUpdate,$e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_array,$e.prototype._setValue_array_setNeedsUpdate,$e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_arrayElement,$e.prototype._setValue_arrayElement_setNeedsUpdate,$e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_fromArray,$e.prototype._setValue_fromArray_setNeedsUpdate,$e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var sA=new Float32Array(1);var Ks=class extends vc{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var Do=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var uf=class uf{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};uf.prototype.isMatrix2=!0;var wd=uf;var zg=new q,sc=new q,So=new q,Mo=new q,_d=new q,fS=new q,pS=new q,Ga=class{constructor(t=new q,e=new q){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){zg.subVectors(t,this.start),sc.subVectors(this.end,this.start);let i=sc.dot(sc);if(i===0)return 0;let r=sc.dot(zg)/i;return e&&(r=ce(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=fS,i=pS){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,h=t.end;So.subVectors(l,a),Mo.subVectors(h,c),_d.subVectors(a,c);let d=So.dot(So),u=Mo.dot(Mo),m=Mo.dot(_d);if(d<=s&&u<=s)return e.copy(a),i.copy(c),e.distanceToSquared(i);if(d<=s)r=0,o=m/u,o=ce(o,0,1);else{let g=So.dot(_d);if(u<=s)o=0,r=ce(-g/d,0,1);else{let x=So.dot(Mo),p=d*u-x*x;p!==0?r=ce((x*m-g*u)/p,0,1):r=0,o=(x*r+m)/u,o<0?(o=0,r=ce(-g/d,0,1)):o>1&&(o=1,r=ce((x-g)/d,0,1))}}return e.copy(a).addScaledVector(So,r),i.copy(c).addScaledVector(Mo,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Ha=class extends Ac{constructor(t=10,e=10,i=4473924,s=8947848){i=new he(i),s=new he(s);let r=e/2,o=t/e,a=t/2,c=[],l=[];for(let u=0,m=0,g=-a;u<=e;u++,g+=o){c.push(-a,0,g,a,0,g),c.push(g,0,-a,g,0,a);let x=u===r?i:s;x.toArray(l,m),m+=3,x.toArray(l,m),m+=3,x.toArray(l,m),m+=3,x.toArray(l,m),m+=3}let h=new ii;h.setAttribute("position",new Ve(c,3)),h.setAttribute("color",new Ve(l,3));let d=new Ta({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Wa=class extends Oi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function of(n,t,e,i){let s=mS(i);switch(e){case Wd:return n*t;case qd:return n*t/s.components*s.byteLength;case Jc:return n*t/s.components*s.byteLength;case nr:return n*t*2/s.components*s.byteLength;case jc:return n*t*2/s.components*s.byteLength;case Xd:return n*t*3/s.components*s.byteLength;case Hi:return n*t*4/s.components*s.byteLength;case Kc:return n*t*4/s.components*s.byteLength;case Ya:case $a:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Za:case Ja:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case th:case nh:return Math.max(n,16)*Math.max(t,8)/4;case Qc:case eh:return Math.max(n,8)*Math.max(t,8)/2;case ih:case sh:case oh:case ah:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case rh:case ja:case lh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ch:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case uh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case dh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case fh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case ph:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case mh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case gh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case _h:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case xh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case yh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case vh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Sh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Mh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case bh:case wh:case Eh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Th:case Ah:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ka:case Rh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function mS(n){switch(n){case si:case kd:return{byteLength:1,components:1};case Oo:case Vd:case Gi:return{byteLength:2,components:1};case $c:case Zc:return{byteLength:2,components:4};case ki:case Yc:case Vi:return{byteLength:4,components:1};case Gd:case Hd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function q0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function _S(n){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,d=l.byteLength,u=n.createBuffer();n.bindBuffer(c,u),n.bufferData(c,l,h),a.onUploadCallback();let m;if(l instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=n.SHORT;else if(l instanceof Uint32Array)m=n.UNSIGNED_INT;else if(l instanceof Int32Array)m=n.INT;else if(l instanceof Int8Array)m=n.BYTE;else if(l instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:u,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,c,l){let h=c.array,d=c.updateRanges;if(n.bindBuffer(l,a),d.length===0)n.bufferSubData(l,0,h);else{d.sort((m,g)=>m.start-g.start);let u=0;for(let m=1;m<d.length;m++){let g=d[u],x=d[m];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++u,d[u]=x)}d.length=u+1;for(let m=0,g=d.length;m<g;m++){let x=d[m];n.bufferSubData(l,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var xS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,vS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,SS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,MS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,wS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ES=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,TS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,AS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,RS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,CS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,PS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,IS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,LS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,DS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,NS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,US=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,FS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,BS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,zS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,kS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,VS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,GS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,HS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,WS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,XS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,qS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,YS="gl_FragColor = linearToOutputTexel( gl_FragColor );",$S=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ZS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,JS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,jS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,KS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,QS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,tM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,eM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,nM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,iM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,sM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,rM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,oM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,aM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,cM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,hM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,uM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,dM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,fM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,pM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,mM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,gM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,_M=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,xM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,yM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,vM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,SM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,MM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,wM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,EM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,TM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,AM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,RM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,CM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,PM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,IM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,LM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,NM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,UM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,FM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,OM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,BM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,kM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,VM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,GM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,HM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,WM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,XM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,qM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,YM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$M=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ZM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,JM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,KM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,QM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,tb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,eb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,nb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ib=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,sb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,rb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ob=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,ab=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,lb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,hb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ub=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,db=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,fb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,pb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,mb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,gb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_b=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,xb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Mb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,wb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Eb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Tb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Ab=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Rb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Cb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Pb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ib=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Lb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Db=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Nb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ub=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Fb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ob=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Bb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,zb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Gb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Wb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Xb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,qb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Yb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$b=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Zb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Jb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,fe={alphahash_fragment:xS,alphahash_pars_fragment:yS,alphamap_fragment:vS,alphamap_pars_fragment:SS,alphatest_fragment:MS,alphatest_pars_fragment:bS,aomap_fragment:wS,aomap_pars_fragment:ES,batching_pars_vertex:TS,batching_vertex:AS,begin_vertex:RS,beginnormal_vertex:CS,bsdfs:PS,iridescence_fragment:IS,bumpmap_pars_fragment:LS,clipping_planes_fragment:DS,clipping_planes_pars_fragment:NS,clipping_planes_pars_vertex:US,clipping_planes_vertex:FS,color_fragment:OS,color_pars_fragment:BS,color_pars_vertex:zS,color_vertex:kS,common:VS,defaultnormal_vertex:GS,displacementmap_pars_vertex:HS,displacementmap_vertex:WS,emissivemap_fragment:XS,emissivemap_pars_fragment:qS,colorspace_fragment:YS,colorspace_pars_fragment:$S,envmap_fragment:ZS,envmap_common_pars_fragment:JS,envmap_pars_fragment:jS,envmap_pars_vertex:KS,envmap_physical_pars_fragment:cM,envmap_vertex:QS,fog_vertex:tM,fog_pars_vertex:eM,fog_fragment:nM,fog_pars_fragment:iM,gradientmap_pars_fragment:sM,lightmap_pars_fragment:rM,lights_lambert_fragment:oM,lights_lambert_pars_fragment:aM,lights_pars_begin:lM,lights_toon_fragment:hM,lights_toon_pars_fragment:uM,lights_phong_fragment:dM,lights_phong_pars_fragment:fM,lights_physical_fragment:pM,lights_physical_pars_fragment:mM,lights_fragment_begin:gM,lights_fragment_maps:_M,lights_fragment_end:xM,lightprobes_pars_fragment:yM,logdepthbuf_fragment:vM,logdepthbuf_pars_fragment:SM,logdepthbuf_pars_vertex:MM,logdepthbuf_vertex:bM,map_fragment:wM,map_pars_fragment:EM,map_particle_fragment:TM,map_particle_pars_fragment:AM,metalnessmap_fragment:RM,metalnessmap_pars_fragment:CM,morphinstance_vertex:PM,morphcolor_vertex:IM,morphnormal_vertex:LM,morphtarget_pars_vertex:DM,morphtarget_vertex:NM,normal_fragment_begin:UM,normal_fragment_maps:FM,normal_pars_fragment:OM,normal_pars_vertex:BM,normal_vertex:zM,normalmap_pars_fragment:kM,clearcoat_normal_fragment_begin:VM,clearcoat_normal_fragment_maps:GM,clearcoat_pars_fragment:HM,iridescence_pars_fragment:WM,opaque_fragment:XM,packing:qM,premultiplied_alpha_fragment:YM,project_vertex:$M,dithering_fragment:ZM,dithering_pars_fragment:JM,roughnessmap_fragment:jM,roughnessmap_pars_fragment:KM,shadowmap_pars_fragment:QM,shadowmap_pars_vertex:tb,shadowmap_vertex:eb,shadowmask_pars_fragment:nb,skinbase_vertex:ib,skinning_pars_vertex:sb,skinning_vertex:rb,skinnormal_vertex:ob,specularmap_fragment:ab,specularmap_pars_fragment:lb,tonemapping_fragment:cb,tonemapping_pars_fragment:hb,transmission_fragment:ub,transmission_pars_fragment:db,uv_pars_fragment:fb,uv_pars_vertex:pb,uv_vertex:mb,worldpos_vertex:gb,background_vert:_b,background_frag:xb,backgroundCube_vert:yb,backgroundCube_frag:vb,cube_vert:Sb,cube_frag:Mb,depth_vert:bb,depth_frag:wb,distance_vert:Eb,distance_frag:Tb,equirect_vert:Ab,equirect_frag:Rb,linedashed_vert:Cb,linedashed_frag:Pb,meshbasic_vert:Ib,meshbasic_frag:Lb,meshlambert_vert:Db,meshlambert_frag:Nb,meshmatcap_vert:Ub,meshmatcap_frag:Fb,meshnormal_vert:Ob,meshnormal_frag:Bb,meshphong_vert:zb,meshphong_frag:kb,meshphysical_vert:Vb,meshphysical_frag:Gb,meshtoon_vert:Hb,meshtoon_frag:Wb,points_vert:Xb,points_frag:qb,shadow_vert:Yb,shadow_frag:$b,sprite_vert:Zb,sprite_frag:Jb},It={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},ei={basic:{uniforms:kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:kn([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:kn([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new he(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:kn([It.points,It.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:kn([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:kn([It.common,It.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:kn([It.sprite,It.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:kn([It.common,It.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:kn([It.lights,It.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};ei.physical={uniforms:kn([ei.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var Ih={r:0,b:0,g:0},jb=new Fe,Y0=new re;Y0.set(-1,0,0,0,1,0,0,0,1);function Kb(n,t,e,i,s,r){let o=new he(0),a=s===!0?0:1,c,l,h=null,d=0,u=null;function m(M){let P=M.isScene===!0?M.background:null;if(P&&P.isTexture){let S=M.backgroundBlurriness>0;P=t.get(P,S)}return P}function g(M){let P=!1,S=m(M);S===null?p(o,a):S&&S.isColor&&(p(S,1),P=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||P)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(M,P){let S=m(P);S&&S.isCubeTexture?(l===void 0&&(l=new zn(new $s(1,1,1),new Ei({name:"BackgroundCubeMaterial",uniforms:Lr(ei.backgroundCube.uniforms),vertexShader:ei.backgroundCube.vertexShader,fragmentShader:ei.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=P.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(jb.makeRotationFromEuler(P.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Y0),l.material.toneMapped=ve.getTransfer(S.colorSpace)!==Ie,(h!==S||d!==S.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=n.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new zn(new Ar(2,2),new Ei({name:"BackgroundMaterial",uniforms:Lr(ei.background.uniforms),vertexShader:ei.background.vertexShader,fragmentShader:ei.background.fragmentShader,side:er,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,c.material.toneMapped=ve.getTransfer(S.colorSpace)!==Ie,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=n.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function p(M,P){M.getRGB(Ih,nf(n)),e.buffers.color.setClear(Ih.r,Ih.g,Ih.b,P,r)}function f(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,P=1){o.set(M),a=P,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,p(o,a)},render:g,addToRenderList:x,dispose:f}}function Qb(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(b,D,F,I,O){let H=!1,z=d(b,I,F,D);r!==z&&(r=z,l(r.object)),H=m(b,I,F,O),H&&g(b,I,F,O),O!==null&&t.update(O,n.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,S(b,D,F,I),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(O).buffer))}function c(){return n.createVertexArray()}function l(b){return n.bindVertexArray(b)}function h(b){return n.deleteVertexArray(b)}function d(b,D,F,I){let O=I.wireframe===!0,H=i[D.id];H===void 0&&(H={},i[D.id]=H);let z=b.isInstancedMesh===!0?b.id:0,Q=H[z];Q===void 0&&(Q={},H[z]=Q);let Y=Q[F.id];Y===void 0&&(Y={},Q[F.id]=Y);let Z=Y[O];return Z===void 0&&(Z=u(c()),Y[O]=Z),Z}function u(b){let D=[],F=[],I=[];for(let O=0;O<e;O++)D[O]=0,F[O]=0,I[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:F,attributeDivisors:I,object:b,attributes:{},index:null}}function m(b,D,F,I){let O=r.attributes,H=D.attributes,z=0,Q=F.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let nt=O[Y],lt=H[Y];if(lt===void 0&&(Y==="instanceMatrix"&&b.instanceMatrix&&(lt=b.instanceMatrix),Y==="instanceColor"&&b.instanceColor&&(lt=b.instanceColor)),nt===void 0||nt.attribute!==lt||lt&&nt.data!==lt.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function g(b,D,F,I){let O={},H=D.attributes,z=0,Q=F.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let nt=H[Y];nt===void 0&&(Y==="instanceMatrix"&&b.instanceMatrix&&(nt=b.instanceMatrix),Y==="instanceColor"&&b.instanceColor&&(nt=b.instanceColor));let lt={};lt.attribute=nt,nt&&nt.data&&(lt.data=nt.data),O[Y]=lt,z++}r.attributes=O,r.attributesNum=z,r.index=I}function x(){let b=r.newAttributes;for(let D=0,F=b.length;D<F;D++)b[D]=0}function p(b){f(b,0)}function f(b,D){let F=r.newAttributes,I=r.enabledAttributes,O=r.attributeDivisors;F[b]=1,I[b]===0&&(n.enableVertexAttribArray(b),I[b]=1),O[b]!==D&&(n.vertexAttribDivisor(b,D),O[b]=D)}function M(){let b=r.newAttributes,D=r.enabledAttributes;for(let F=0,I=D.length;F<I;F++)D[F]!==b[F]&&(n.disableVertexAttribArray(F),D[F]=0)}function P(b,D,F,I,O,H,z){z===!0?n.vertexAttribIPointer(b,D,F,O,H):n.vertexAttribPointer(b,D,F,I,O,H)}function S(b,D,F,I){x();let O=I.attributes,H=F.getAttributes(),z=D.defaultAttributeValues;for(let Q in H){let Y=H[Q];if(Y.location>=0){let Z=O[Q];if(Z===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(Z=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(Z=b.instanceColor)),Z!==void 0){let nt=Z.normalized,lt=Z.itemSize,ht=t.get(Z);if(ht===void 0)continue;let tt=ht.buffer,mt=ht.type,_t=ht.bytesPerElement,ot=mt===n.INT||mt===n.UNSIGNED_INT||Z.gpuType===Yc;if(Z.isInterleavedBufferAttribute){let dt=Z.data,Nt=dt.isInterleavedBuffer===!0?dt.stride:dt.itemSize,$t=Z.offset;if(dt.isInstancedInterleavedBuffer||dt.isInstancedBufferAttribute){for(let Ot=0;Ot<Y.locationSize;Ot++)f(Y.location+Ot,dt.meshPerAttribute);b.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=dt.meshPerAttribute*dt.count)}else for(let Ot=0;Ot<Y.locationSize;Ot++)p(Y.location+Ot);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Ot=0;Ot<Y.locationSize;Ot++)P(Y.location+Ot,lt/Y.locationSize,mt,nt,Nt*_t,($t+lt/Y.locationSize*Ot)*_t,ot)}else{if(Z.isInstancedBufferAttribute){for(let dt=0;dt<Y.locationSize;dt++)f(Y.location+dt,Z.meshPerAttribute);b.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let dt=0;dt<Y.locationSize;dt++)p(Y.location+dt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let dt=0;dt<Y.locationSize;dt++)P(Y.location+dt,lt/Y.locationSize,mt,nt,lt*_t,lt/Y.locationSize*dt*_t,ot)}}else if(z!==void 0){let nt=z[Q];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv(Y.location,nt);break;case 3:n.vertexAttrib3fv(Y.location,nt);break;case 4:n.vertexAttrib4fv(Y.location,nt);break;default:n.vertexAttrib1fv(Y.location,nt)}}}}M()}function C(){L();for(let b in i){let D=i[b];for(let F in D){let I=D[F];for(let O in I){let H=I[O];for(let z in H)h(H[z].object),delete H[z];delete I[O]}}delete i[b]}}function E(b){if(i[b.id]===void 0)return;let D=i[b.id];for(let F in D){let I=D[F];for(let O in I){let H=I[O];for(let z in H)h(H[z].object),delete H[z];delete I[O]}}delete i[b.id]}function _(b){for(let D in i){let F=i[D];for(let I in F){let O=F[I];if(O[b.id]===void 0)continue;let H=O[b.id];for(let z in H)h(H[z].object),delete H[z];delete O[b.id]}}}function v(b){for(let D in i){let F=i[D],I=b.isInstancedMesh===!0?b.id:0,O=F[I];if(O!==void 0){for(let H in O){let z=O[H];for(let Q in z)h(z[Q].object),delete z[Q];delete O[H]}delete F[I],Object.keys(F).length===0&&delete i[D]}}}function L(){T(),o=!0,r!==s&&(r=s,l(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:T,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:v,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:p,disableUnusedAttributes:M}}function t1(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),e.update(l,i,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let u=0;for(let m=0;m<h;m++)u+=l[m];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function e1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Hi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let v=_===Gi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==si&&_!==Vi&&!v&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Jt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),P=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:M,maxVaryings:P,maxFragmentUniforms:S,maxSamples:C,samples:E}}function n1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new mi,a=new re,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let m=d.length!==0||u||i!==0||s;return s=u,i=d.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,m){let g=d.clippingPlanes,x=d.clipIntersection,p=d.clipShadows,f=n.get(d);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let M=r?0:i,P=M*4,S=f.clippingState||null;c.value=S,S=h(g,u,P,m);for(let C=0;C!==P;++C)S[C]=e[C];f.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,u,m,g){let x=d!==null?d.length:0,p=null;if(x!==0){if(p=c.value,g!==!0||p===null){let f=m+x*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(p===null||p.length<f)&&(p=new Float32Array(f));for(let P=0,S=m;P!==x;++P,S+=4)o.copy(d[P]).applyMatrix4(M,a),o.normal.toArray(p,S),p[S+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var il=class extends gi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Aa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $s(5,5,5),r=new Ei({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:Rr});r.uniforms.tEquirect.value=e;let o=new zn(s,r),a=e.minFilter;return e.minFilter===Es&&(e.minFilter=jn),new Lo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},E0=256,i1=3,s1=20,$0=256,Z0=16,r1=3,o1=new q,a1=new he,Dh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Lo(1,10,null),this._boxMesh=new zn(new $s(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=o1}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,u=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,x=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(t.background=c.getClearColor(a1));let p=new Lo(i,s,h);return p.position.copy(a),p.update(c,t),c.autoClear=d,c.autoClearColor=u,c.autoClearDepth=m,c.autoClearStencil=g,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=R0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=A0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(E0,Qd(t))}_fromTexture(t,e){t.mapping===Pr||t.mapping===Fo?this._setSize(t.image.length===0?E0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=T0(t,!1,!1),i=Math.log2(t)-i1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=T0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Pr||t.mapping===Fo?(this._cubemapMaterial===null&&(this._cubemapMaterial=R0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=A0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=l1(),this._integrationMaterial=c1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Z0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-r1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/($0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=h1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function T0(n,t,e){return new il(n,{minFilter:Es,generateMipmaps:t,type:Gi,colorSpace:_a,depthBuffer:e})}function sl(n,t,e){return new Ei({name:n,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ti,blending:Rr,depthTest:!1,depthWrite:!1})}function l1(){return sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${$0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function c1(){return sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Z0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function h1(){return sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${s1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function A0(){return sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function R0(){return sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function u1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,m=!1){return u==null?null:m?o(u):r(u)}function r(u){if(u&&u.isTexture){let m=u.mapping;if(m===Wc||m===Xc)if(t.has(u)){let g=t.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let x=new il(g.height);return x.fromEquirectangularTexture(n,u),t.set(u,x),u.addEventListener("dispose",l),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let m=u.mapping,g=m===Wc||m===Xc,x=m===Pr||m===Fo;if(g||x){let p=e.get(u),f=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==f)return i===null&&(i=new Dh(n)),p=g?i.fromEquirectangular(u,p):i.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),p.texture;if(p!==void 0)return p.texture;{let M=u.image;return g&&M&&M.height>0||x&&M&&c(M)?(i===null&&(i=new Dh(n)),p=g?i.fromEquirectangular(u):i.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),u.addEventListener("dispose",h),p.texture):null}}}return u}function a(u,m){return m===Wc?u.mapping=Pr:m===Xc&&(u.mapping=Fo),u}function c(u){let m=0,g=6;for(let x=0;x<g;x++)u[x]!==void 0&&m++;return m===g}function l(u){let m=u.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(u){let m=u.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function d1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&fa("WebGLRenderer: "+i+" extension not supported."),s}}}function f1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(g){let x=g.attributes;for(let p in x)t.update(x[p],n.ARRAY_BUFFER)}function d(g){let x=g.index,p=g.attributes.position,f=0;if(p===void 0)return;let M=x!==null?x.array.length:p.array.length/3-1,P=p.count>=65535?Ea:wa,S=new P(Math.ceil(M/3)*6,1),C=S.array;if(x!==null){let _=x.array;f=x.version;for(let v=0,L=0;v<M;v+=3){let T=_[v+0],b=_[v+1],D=_[v+2];C[L++]=T,C[L++]=b,C[L++]=b,C[L++]=D,C[L++]=D,C[L++]=T}}else{f=p.version;for(let _=0,v=0;_<M;_+=3){let L=_+0,T=_+1,b=_+2;C[v++]=L,C[v++]=T,C[v++]=T,C[v++]=b,C[v++]=b,C[v++]=L}}S.version=f;let E=r.get(g);E&&t.remove(E),r.set(g,S)}function u(g){let x=r.get(g);if(x){let p=g.index;p!==null&&x.version<p.version&&d(g)}else d(g);return r.get(g)}function m(){for(let g in s){let x=s[g].deref();x!==void 0&&c(x)}}return{get:l,update:h,getWireframeAttribute:u,dispose:m}}function p1(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,u){n.drawElements(i,u,r,d*o),e.update(u,i,1)}function l(d,u,m){m!==0&&(n.drawElementsInstanced(i,u,r,d*o,m),e.update(u,i,m))}function h(d,u,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,m);let x=0;for(let p=0;p<m;p++)x+=u[p];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function m1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function g1(n,t,e){let i=new WeakMap,s=new Le;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let L=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",L)};u!==void 0&&u.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],P=0;m===!0&&(P=1),g===!0&&(P=2),x===!0&&(P=3);let S=a.attributes.position.count*P,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let E=new Float32Array(S*C*4*d),_=new Sa(E,S,C,d);_.type=Vi,_.needsUpdate=!0;let v=P*4;for(let T=0;T<d;T++){let b=p[T],D=f[T],F=M[T],I=S*C*4*T;for(let O=0;O<b.count;O++){let H=O*v;m===!0&&(s.fromBufferAttribute(b,O),E[I+H+0]=s.x,E[I+H+1]=s.y,E[I+H+2]=s.z,E[I+H+3]=0),g===!0&&(s.fromBufferAttribute(D,O),E[I+H+4]=s.x,E[I+H+5]=s.y,E[I+H+6]=s.z,E[I+H+7]=0),x===!0&&(s.fromBufferAttribute(F,O),E[I+H+8]=s.x,E[I+H+9]=s.y,E[I+H+10]=s.z,E[I+H+11]=F.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new Kt(S,C)},i.set(a,u),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let m=0;for(let x=0;x<l.length;x++)m+=l[x];let g=a.morphTargetsRelative?1:1-m;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function _1(n,t,e,i,s){let r=new WeakMap;function o(l){let h=s.render.frame,d=l.geometry,u=t.get(l,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return u}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var x1={[Ld]:"LINEAR_TONE_MAPPING",[Dd]:"REINHARD_TONE_MAPPING",[Nd]:"CINEON_TONE_MAPPING",[Ud]:"ACES_FILMIC_TONE_MAPPING",[Od]:"AGX_TONE_MAPPING",[Bd]:"NEUTRAL_TONE_MAPPING",[Fd]:"CUSTOM_TONE_MAPPING"};function y1(n,t,e,i,s,r){let o=new gi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new ii;h.setAttribute("position",new Ve([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ve([0,2,0,0,2,0],2));let d=new Rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new zn(h,d),m=new za(-1,1,1,-1,0,1),g=null,x=null,p=!1,f,M=null,P=[],S=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),c!==null&&c.setSize(C,E);for(let _=0;_<P.length;_++){let v=P[_];v.setSize&&v.setSize(C,E)}},this.setEffects=function(C){P=C,S=P.length>0&&P[0].isRenderPass===!0;let E=o.width,_=o.height;P.length>0&&a===null&&(a=new gi(E,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}),c=new gi(E,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}));let v=s===!0&&P.some(L=>L.needsDepthTexture===!0);v!==(o.depthTexture!==null)&&(v===!0&&l===null&&(l=new ws(E,_),r===!0&&(l.format=Ts,l.type=Ir)),o.dispose(),o.depthTexture=v?l:null,o.resolveDepthBuffer=v,o.storeMultisampledDepthBuffer=v);for(let L=0;L<P.length;L++){let T=P[L];T.setSize&&T.setSize(E,_),v&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(l)}},this.begin=function(C,E){if(p||C.toneMapping===is&&P.length===0)return!1;if(M=E,E!==null){let _=E.width,v=E.height;(o.width!==_||o.height!==v)&&this.setSize(_,v)}return S===!1&&C.setRenderTarget(o),f=C.toneMapping,C.toneMapping=is,!0},this.hasRenderPass=function(){return S},this.end=function(C,E){C.toneMapping=f,p=!0;let _=o,v=a;for(let L=0;L<P.length;L++){let T=P[L];T.enabled!==!1&&(T.render(C,v,_,E),T.needsSwap!==!1&&(_=v,v=v===a?c:a))}if(g!==C.outputColorSpace||x!==C.toneMapping){g=C.outputColorSpace,x=C.toneMapping,d.defines={},ve.getTransfer(g)===Ie&&(d.defines.SRGB_TRANSFER="");let L=x1[x];L&&(d.defines[L]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(M),C.render(u,m),M=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),d.dispose()}}var J0=new Qn,j0=new ws(1,1),K0=new Ca(1),Q0=new Sa,t_=new yc,e_=new Aa,C0=[],P0=[],I0=new Float32Array(16),L0=new Float32Array(9),D0=new Float32Array(4);function zo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=C0[s];if(r===void 0&&(r=new Float32Array(s),C0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function yn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function vn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Uh(n,t){let e=P0[t];e===void 0&&(e=new Int32Array(t),P0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function v1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function S1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2fv(this.addr,t),vn(e,t)}}function M1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;n.uniform3fv(this.addr,t),vn(e,t)}}function b1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4fv(this.addr,t),vn(e,t)}}function w1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;D0.set(i),n.uniformMatrix2fv(this.addr,!1,D0),vn(e,i)}}function E1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;L0.set(i),n.uniformMatrix3fv(this.addr,!1,L0),vn(e,i)}}function T1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;I0.set(i),n.uniformMatrix4fv(this.addr,!1,I0),vn(e,i)}}function A1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function R1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2iv(this.addr,t),vn(e,t)}}function C1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3iv(this.addr,t),vn(e,t)}}function P1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4iv(this.addr,t),vn(e,t)}}function I1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function L1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2uiv(this.addr,t),vn(e,t)}}function D1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3uiv(this.addr,t),vn(e,t)}}function N1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4uiv(this.addr,t),vn(e,t)}}function Fh(n){return n.version===0&&(n.compareFunction=Zd,n.needsUpdate=!0),n}function U1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Fh(j0):r=J0,e.setTexture2D(t||r,s)}function F1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||t_,s)}function O1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Fh(K0):r=e_,e.setTextureCube(t||r,s)}function B1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Q0,s)}function z1(n){switch(n){case 5126:return v1;case 35664:return S1;case 35665:return M1;case 35666:return b1;case 35674:return w1;case 35675:return E1;case 35676:return T1;case 5124:case 35670:return A1;case 35667:case 35671:return R1;case 35668:case 35672:return C1;case 35669:case 35673:return P1;case 5125:return I1;case 36294:return L1;case 36295:return D1;case 36296:return N1;case 35678:case 36198:case 36298:case 36306:case 35682:return U1;case 35679:case 36299:case 36307:return F1;case 35680:case 36300:case 36308:case 36293:return O1;case 36289:case 36303:case 36311:case 36292:return B1}}function k1(n,t){n.uniform1fv(this.addr,t)}function V1(n,t){let e=zo(t,this.size,2);n.uniform2fv(this.addr,e)}function G1(n,t){let e=zo(t,this.size,3);n.uniform3fv(this.addr,e)}function H1(n,t){let e=zo(t,this.size,4);n.uniform4fv(this.addr,e)}function W1(n,t){let e=zo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function X1(n,t){let e=zo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function q1(n,t){let e=zo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Y1(n,t){n.uniform1iv(this.addr,t)}function $1(n,t){n.uniform2iv(this.addr,t)}function Z1(n,t){n.uniform3iv(this.addr,t)}function J1(n,t){n.uniform4iv(this.addr,t)}function j1(n,t){n.uniform1uiv(this.addr,t)}function K1(n,t){n.uniform2uiv(this.addr,t)}function Q1(n,t){n.uniform3uiv(this.addr,t)}function tw(n,t){n.uniform4uiv(this.addr,t)}function ew(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Fh(j0):o=J0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function nw(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||t_,r[o])}function iw(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Fh(K0):o=e_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function sw(n,t,e){let i=this.cache,s=t.length,r=Uh(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Q0,r[o])}function rw(n){switch(n){case 5126:return k1;case 35664:return V1;case 35665:return G1;case 35666:return H1;case 35674:return W1;case 35675:return X1;case 35676:return q1;case 5124:case 35670:return Y1;case 35667:case 35671:return $1;case 35668:case 35672:return Z1;case 35669:case 35673:return J1;case 5125:return j1;case 36294:return K1;case 36295:return Q1;case 36296:return tw;case 35678:case 36198:case 36298:case 36306:case 35682:return ew;case 35679:case 36299:case 36307:return nw;case 35680:case 36300:case 36308:case 36293:return iw;case 36289:case 36303:case 36311:case 36292:return sw}}var pf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=z1(e.type)}},mf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=rw(e.type)}},gf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},df=/(\w+)(\])?(\[|\.)?/g;function N0(n,t){n.seq.push(t),n.map[t.id]=t}function ow(n,t,e){let i=n.name,s=i.length;for(df.lastIndex=0;;){let r=df.exec(i),o=df.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){N0(e,l===void 0?new pf(a,n,t):new mf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new gf(a),N0(e,d)),e=d}}}var Bo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);ow(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function U0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var aw=37297,lw=0;function cw(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var F0=new re;function hw(n){ve._getMatrix(F0,ve.workingColorSpace,n);let t=`mat3( ${F0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case xa:return[t,"LinearTransferOETF"];case Ie:return[t,"sRGBTransferOETF"];default:return Jt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function O0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+cw(n.getShaderSource(t),a)}else return r}function uw(n,t){let e=hw(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var dw={[Ld]:"Linear",[Dd]:"Reinhard",[Nd]:"Cineon",[Ud]:"ACESFilmic",[Od]:"AgX",[Bd]:"Neutral",[Fd]:"Custom"};function fw(n,t){let e=dw[t];return e===void 0?(Jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Lh=new q;function pw(){ve.getLuminanceCoefficients(Lh);let n=Lh.x.toFixed(4),t=Lh.y.toFixed(4),e=Lh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function mw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(nl).join(`
`)}function gw(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function _w(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function nl(n){return n!==""}function B0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function z0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var xw=/^[ \t]*#include +<([\w\d./]+)>/gm;function _f(n){return n.replace(xw,yw)}function yw(n,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return _f(e)}var vw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function k0(n){return n.replace(vw,Sw)}function Sw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function V0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Mw={[Xa]:"SHADOWMAP_TYPE_PCF",[No]:"SHADOWMAP_TYPE_VSM"};function bw(n){return Mw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ww={[Fo]:"ENVMAP_MODE_REFRACTION"};function Ew(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":ww[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Tw={[Id]:"ENVMAP_BLENDING_MULTIPLY",[a0]:"ENVMAP_BLENDING_MIX",[l0]:"ENVMAP_BLENDING_ADD"};function Aw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Tw[n.combine]||"ENVMAP_BLENDING_NONE"}function Rw(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=bw(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ew(e),d=Aw(e),u=mw(e),m=gw(r),g=s.createProgram(),x,p,f=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(nl).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(nl).join(`
`),p.length>0&&(p+=`
`)):(x=[V0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(nl).join(`
`),p=[V0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==is?"#define TONE_MAPPING":"",e.toneMapping!==is?fe.tonemapping_pars_fragment:"",e.toneMapping!==is?fw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,uw("linearToOutputTexel",e.outputColorSpace),pw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(nl).join(`
`)),o=_f(o),o=B0(o,e),o=z0(o,e),a=_f(a),a=B0(a,e),a=z0(a,e),o=k0(o),a=k0(a),e.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",e.glslVersion===jd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===jd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let M=f+x+o,P=f+p+a,S=U0(s,s.VERTEX_SHADER,M),C=U0(s,s.FRAGMENT_SHADER,P);s.attachShader(g,S),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(T){if(n.debug.checkShaderErrors){let b=s.getProgramInfoLog(g)||"",D=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(C)||"",I=b.trim(),O=D.trim(),H=F.trim(),z=!0,Q=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let Y=O0(s,S,"vertex"),Z=O0(s,C,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+I+`
`+Y+`
`+Z)}else I!==""?Jt("WebGLProgram: Program Info Log:",I):(O===""||H==="")&&(Q=!1);Q&&(T.diagnostics={runnable:z,programLog:I,vertexShader:{log:O,prefix:x},fragmentShader:{log:H,prefix:p}})}s.deleteShader(S),s.deleteShader(C),_=new Bo(s,g),v=_w(s,g)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let v;this.getAttributes=function(){return v===void 0&&E(this),v};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,aw)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=lw++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var Cw=0,xf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new yf(t),e.set(t,i)),i}},yf=class{constructor(t){this.id=Cw++,this.code=t,this.usedTimes=0}};function Pw(n){return n===nr||n===ja||n===Ka}function Iw(n,t,e,i,s,r){let o=new Ma,a=new xf,c=new Set,l=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(_){return c.add(_),_===0?"uv":`uv${_}`}function g(_,v,L,T,b,D){let F=T.fog,I=b.geometry,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?T.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=t.get(_.envMap||O,H),Q=u[_.type],Y=i.precision;_.precision!==null&&(Y=i.getMaxPrecision(_.precision),Y!==_.precision&&Jt("WebGLProgram.getParameters:",_.precision,"not supported, using",Y,"instead."));let Z=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,nt=Z!==void 0?Z.length:0,lt=0;I.morphAttributes.position!==void 0&&(lt=1),I.morphAttributes.normal!==void 0&&(lt=2),I.morphAttributes.color!==void 0&&(lt=3);let ht,tt,mt,_t;if(Q){let Rt=ei[Q];ht=Rt.vertexShader,tt=Rt.fragmentShader}else{ht=_.vertexShader,tt=_.fragmentShader;let Rt=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,Rt,ue),mt=Rt.id,_t=ue.id}let ot=n.getRenderTarget(),dt=n.state.buffers.depth.getReversed(),Nt=b.isInstancedMesh===!0,$t=b.isBatchedMesh===!0,Ot=!!_.map,se=!!_.matcap,ae=!!z,Xt=ae&&z.isPMREMTexture===!0,Se=!!_.aoMap,Ce=!!_.lightMap,je=!!_.bumpMap&&_.wireframe===!1,Ee=!!_.normalMap,Mn=!!_.displacementMap,Me=!!_.emissiveMap,mn=!!_.metalnessMap,Ke=!!_.roughnessMap,on=_.anisotropy>0,V=_.clearcoat>0,Ct=_.diffuseRoughness>0,jt=_.dispersion>0,le=_.retroreflectivity>0,wt=_.iridescence>0,Be=_.sheen>0,Wt=_.transmission>0,Zt=on&&!!_.anisotropyMap,N=V&&!!_.clearcoatMap,w=V&&!!_.clearcoatNormalMap,$=V&&!!_.clearcoatRoughnessMap,pt=Ct&&!!_.diffuseRoughnessMap,ct=wt&&!!_.iridescenceMap,vt=wt&&!!_.iridescenceThicknessMap,St=Be&&!!_.sheenColorMap,it=Be&&!!_.sheenRoughnessMap,rt=!!_.specularMap,xt=!!_.specularColorMap,k=!!_.specularIntensityMap,at=Wt&&!!_.transmissionMap,st=Wt&&!!_.thicknessMap,Et=!!_.gradientMap,yt=!!_.alphaMap,bt=_.alphaTest>0,qt=!!_.alphaHash,te=!!_.extensions,ft=is;_.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(ft=n.toneMapping);let kt=Xt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,ee={shaderID:Q,shaderType:_.type,shaderName:_.name,vertexShader:ht,fragmentShader:tt,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:_t,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Y,batching:$t,batchingColor:$t&&b._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&b.instanceColor!==null,instancingMorph:Nt&&b.morphTexture!==null,outputColorSpace:ot===null?n.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ot,matcap:se,envMap:ae,envMapMode:ae&&z.mapping,envMapPMREM:Xt,envMapMaxLod:Xt?kt.length-1:null,envMapSize:Xt?kt[0].width:null,aoMap:Se,lightMap:Ce,bumpMap:je,normalMap:Ee,displacementMap:Mn,emissiveMap:Me,normalMapObjectSpace:Ee&&_.normalMapType===u0,normalMapTangentSpace:Ee&&_.normalMapType===Ch,packedNormalMap:Ee&&_.normalMapType===Ch&&Pw(_.normalMap.format),metalnessMap:mn,roughnessMap:Ke,anisotropy:on,anisotropyMap:Zt,clearcoat:V,clearcoatMap:N,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Ct,diffuseRoughnessMap:pt,dispersion:jt,retroreflection:le,iridescence:wt,iridescenceMap:ct,iridescenceThicknessMap:vt,sheen:Be,sheenColorMap:St,sheenRoughnessMap:it,specularMap:rt,specularColorMap:xt,specularIntensityMap:k,transmission:Wt,transmissionMap:at,thicknessMap:st,gradientMap:Et,opaque:_.transparent===!1&&_.blending===Uo&&_.alphaToCoverage===!1,alphaMap:yt,alphaTest:bt,alphaHash:qt,combine:_.combine,mapUv:Ot&&m(_.map.channel),aoMapUv:Se&&m(_.aoMap.channel),lightMapUv:Ce&&m(_.lightMap.channel),bumpMapUv:je&&m(_.bumpMap.channel),normalMapUv:Ee&&m(_.normalMap.channel),displacementMapUv:Mn&&m(_.displacementMap.channel),emissiveMapUv:Me&&m(_.emissiveMap.channel),metalnessMapUv:mn&&m(_.metalnessMap.channel),roughnessMapUv:Ke&&m(_.roughnessMap.channel),anisotropyMapUv:Zt&&m(_.anisotropyMap.channel),clearcoatMapUv:N&&m(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&m(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&m(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pt&&m(_.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&m(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&m(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&m(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&m(_.sheenRoughnessMap.channel),specularMapUv:rt&&m(_.specularMap.channel),specularColorMapUv:xt&&m(_.specularColorMap.channel),specularIntensityMapUv:k&&m(_.specularIntensityMap.channel),transmissionMapUv:at&&m(_.transmissionMap.channel),thicknessMapUv:st&&m(_.thicknessMap.channel),alphaMapUv:yt&&m(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ee||on),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:b.isPoints===!0&&!!I.attributes.uv&&(Ot||yt),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Ee===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:dt,skinning:b.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:lt,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:D.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:ft,decodeVideoTexture:Ot&&_.map.isVideoTexture===!0&&ve.getTransfer(_.map.colorSpace)===Ie,decodeVideoTextureEmissive:Me&&_.emissiveMap.isVideoTexture===!0&&ve.getTransfer(_.emissiveMap.colorSpace)===Ie,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ns,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||$t)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ee.vertexUv1s=c.has(1),ee.vertexUv2s=c.has(2),ee.vertexUv3s=c.has(3),c.clear(),ee}function x(_){let v=[];if(_.shaderID?v.push(_.shaderID):(v.push(_.customVertexShaderID),v.push(_.customFragmentShaderID)),_.defines!==void 0)for(let L in _.defines)v.push(L),v.push(_.defines[L]);return _.isRawShaderMaterial===!1&&(p(v,_),f(v,_),v.push(n.outputColorSpace)),v.push(_.customProgramCacheKey),v.join()}function p(_,v){_.push(v.precision),_.push(v.outputColorSpace),_.push(v.envMapMode),_.push(v.envMapPMREM),_.push(v.envMapMaxLod),_.push(v.envMapSize),_.push(v.mapUv),_.push(v.alphaMapUv),_.push(v.lightMapUv),_.push(v.aoMapUv),_.push(v.bumpMapUv),_.push(v.normalMapUv),_.push(v.displacementMapUv),_.push(v.emissiveMapUv),_.push(v.metalnessMapUv),_.push(v.roughnessMapUv),_.push(v.anisotropyMapUv),_.push(v.clearcoatMapUv),_.push(v.clearcoatNormalMapUv),_.push(v.clearcoatRoughnessMapUv),_.push(v.diffuseRoughnessMapUv),_.push(v.iridescenceMapUv),_.push(v.iridescenceThicknessMapUv),_.push(v.sheenColorMapUv),_.push(v.sheenRoughnessMapUv),_.push(v.specularMapUv),_.push(v.specularColorMapUv),_.push(v.specularIntensityMapUv),_.push(v.transmissionMapUv),_.push(v.thicknessMapUv),_.push(v.combine),_.push(v.fogExp2),_.push(v.sizeAttenuation),_.push(v.morphTargetsCount),_.push(v.numSunLights),_.push(v.numDirLights),_.push(v.numPointLights),_.push(v.numSpotLights),_.push(v.numSpotLightMaps),_.push(v.numHemiLights),_.push(v.numRectAreaLights),_.push(v.numSunLightShadows),_.push(v.numDirLightShadows),_.push(v.numPointLightShadows),_.push(v.numSpotLightShadows),_.push(v.numSpotLightShadowsWithMaps),_.push(v.numLightProbes),_.push(v.numLightProbeGrids),_.push(v.shadowMapType),_.push(v.toneMapping),_.push(v.numClippingPlanes),_.push(v.numClipIntersection),_.push(v.depthPacking)}function f(_,v){o.disableAll(),v.instancing&&o.enable(0),v.instancingColor&&o.enable(1),v.instancingMorph&&o.enable(2),v.matcap&&o.enable(3),v.envMap&&o.enable(4),v.normalMapObjectSpace&&o.enable(5),v.normalMapTangentSpace&&o.enable(6),v.clearcoat&&o.enable(7),v.iridescence&&o.enable(8),v.alphaTest&&o.enable(9),v.vertexColors&&o.enable(10),v.vertexAlphas&&o.enable(11),v.vertexUv1s&&o.enable(12),v.vertexUv2s&&o.enable(13),v.vertexUv3s&&o.enable(14),v.vertexTangents&&o.enable(15),v.anisotropy&&o.enable(16),v.alphaHash&&o.enable(17),v.batching&&o.enable(18),v.dispersion&&o.enable(19),v.retroreflection&&o.enable(24),v.diffuseRoughness&&o.enable(25),v.batchingColor&&o.enable(20),v.gradientMap&&o.enable(21),v.packedNormalMap&&o.enable(22),v.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),v.fog&&o.enable(0),v.useFog&&o.enable(1),v.flatShading&&o.enable(2),v.logarithmicDepthBuffer&&o.enable(3),v.reversedDepthBuffer&&o.enable(4),v.skinning&&o.enable(5),v.morphTargets&&o.enable(6),v.morphNormals&&o.enable(7),v.morphColors&&o.enable(8),v.premultipliedAlpha&&o.enable(9),v.shadowMapEnabled&&o.enable(10),v.doubleSided&&o.enable(11),v.flipSided&&o.enable(12),v.useDepthPacking&&o.enable(13),v.dithering&&o.enable(14),v.transmission&&o.enable(15),v.sheen&&o.enable(16),v.opaque&&o.enable(17),v.pointsUvs&&o.enable(18),v.decodeVideoTexture&&o.enable(19),v.decodeVideoTextureEmissive&&o.enable(20),v.alphaToCoverage&&o.enable(21),v.numLightProbeGrids>0&&o.enable(22),v.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function M(_){let v=u[_.type],L;if(v){let T=ei[v];L=tl.clone(T.uniforms)}else L=_.uniforms;return L}function P(_,v){let L=h.get(v);return L!==void 0?++L.usedTimes:(L=new Rw(n,v,_,s),l.push(L),h.set(v,L)),L}function S(_){if(--_.usedTimes===0){let v=l.indexOf(_);l[v]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:M,acquireProgram:P,releaseProgram:S,releaseShaderCache:C,programs:l,dispose:E}}function Lw(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Dw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function G0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function H0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let m=0;return u.isInstancedMesh&&(m+=2),u.isSkinnedMesh&&(m+=1),m}function a(u,m,g,x,p,f){let M=n[t];return M===void 0?(M={id:u.id,object:u,geometry:m,material:g,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:p,group:f},n[t]=M):(M.id=u.id,M.object=u,M.geometry=m,M.material=g,M.materialVariant=o(u),M.groupOrder=x,M.renderOrder=u.renderOrder,M.z=p,M.group=f),t++,M}function c(u,m,g,x,p,f,M){M.reversedDepth===!0&&(p=-p);let P=a(u,m,g,x,p,f);g.transmission>0?i.push(P):g.transparent===!0?s.push(P):e.push(P)}function l(u,m,g,x,p,f){let M=a(u,m,g,x,p,f);g.transmission>0?i.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(u,m){e.length>1&&e.sort(u||Dw),i.length>1&&i.sort(m||G0),s.length>1&&s.sort(m||G0)}function d(){for(let u=t,m=n.length;u<m;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:d,sort:h}}function Nw(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new H0,n.set(i,[o])):s>=r.length?(o=new H0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function Uw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new he};break;case"SpotLight":e={position:new q,direction:new q,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new q,halfWidth:new q,halfHeight:new q};break}return n[t.id]=e,e}}}function Fw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var Ow=0;function Bw(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function zw(n){let t=new Uw,e=Fw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new q);let s=new q,r=new Fe,o=new Fe;function a(l){let h=0,d=0,u=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let m=0,g=0,x=0,p=0,f=0,M=0,P=0,S=0,C=0,E=0,_=0,v=0,L=0,T=0;l.sort(Bw);for(let D=0,F=l.length;D<F;D++){let I=l[D],O=I.color,H=I.intensity,z=I.distance,Q=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===nr?Q=I.shadow.map.texture:Q=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=O.r*H,d+=O.g*H,u+=O.b*H;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(I.sh.coefficients[Y],H);T++}else if(I.isSunLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=nt,i.sunShadowMap[g]=Q;let lt=Z.getViewportCount();for(let ht=0;ht<lt;ht++)i.sunShadowMatrix[x+ht]=Z.getMatrix(ht),i.sunShadowCascade[x+ht]=Z._cascadeData[ht];x+=lt,g++}i.sun[m]=Y,m++}else if(I.isDirectionalLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.directionalShadow[p]=nt,i.directionalShadowMap[p]=Q,i.directionalShadowMatrix[p]=I.shadow.matrix,C++}i.directional[p]=Y,p++}else if(I.isSpotLight){let Y=t.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(O).multiplyScalar(H),Y.distance=z,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,i.spot[M]=Y;let Z=I.shadow;if(I.map&&(i.spotLightMap[v]=I.map,v++,Z.updateMatrices(I),I.castShadow&&L++),i.spotLightMatrix[M]=Z.matrix,I.castShadow){let nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.spotShadow[M]=nt,i.spotShadowMap[M]=Q,_++}M++}else if(I.isRectAreaLight){let Y=t.get(I);Y.color.copy(O).multiplyScalar(H),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),i.rectArea[P]=Y,P++}else if(I.isPointLight){let Y=t.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,nt.shadowCameraNear=Z.camera.near,nt.shadowCameraFar=Z.camera.far,i.pointShadow[f]=nt,i.pointShadowMap[f]=Q,i.pointShadowMatrix[f]=I.shadow.matrix,E++}i.point[f]=Y,f++}else if(I.isHemisphereLight){let Y=t.get(I);Y.skyColor.copy(I.color).multiplyScalar(H),Y.groundColor.copy(I.groundColor).multiplyScalar(H),i.hemi[S]=Y,S++}}P>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=It.LTC_FLOAT_1,i.rectAreaLTC2=It.LTC_FLOAT_2):(i.rectAreaLTC1=It.LTC_HALF_1,i.rectAreaLTC2=It.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let b=i.hash;(b.sunLength!==m||b.directionalLength!==p||b.pointLength!==f||b.spotLength!==M||b.rectAreaLength!==P||b.hemiLength!==S||b.numSunShadows!==g||b.numDirectionalShadows!==C||b.numPointShadows!==E||b.numSpotShadows!==_||b.numSpotMaps!==v||b.numLightProbes!==T)&&(i.sun.length=m,i.directional.length=p,i.spot.length=M,i.rectArea.length=P,i.point.length=f,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+v-L,i.spotLightMap.length=v,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=T,b.sunLength=m,b.directionalLength=p,b.pointLength=f,b.spotLength=M,b.rectAreaLength=P,b.hemiLength=S,b.numSunShadows=g,b.numDirectionalShadows=C,b.numPointShadows=E,b.numSpotShadows=_,b.numSpotMaps=v,b.numLightProbes=T,i.version=Ow++)}function c(l,h){let d=0,u=0,m=0,g=0,x=0,p=0,f=h.matrixWorldInverse;for(let M=0,P=l.length;M<P;M++){let S=l[M];if(S.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(f),d++}else if(S.isDirectionalLight){let C=i.directional[u];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),u++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(f),g++}else if(S.isRectAreaLight){let C=i.rectArea[x];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),o.identity(),r.copy(S.matrixWorld),r.premultiply(f),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let C=i.point[m];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(f),m++}else if(S.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(f),p++}}}return{setup:a,setupView:c,state:i}}function W0(n){let t=new zw(n),e=[],i=[],s=[];function r(d){h.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function c(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function l(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function kw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new W0(n),t.set(s,[a])):r>=o.length?(a=new W0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var Vw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Gw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Hw=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],Ww=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],X0=new Fe,el=new q,ff=new q;function Xw(n,t,e){let i=new Ys,s=new Kt,r=new Kt,o=new Le,a=new Cc,c=new Pc,l={},h=e.maxTextureSize,d={[er]:ti,[ti]:er,[ns]:ns},u=new Ei({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:Vw,fragmentShader:Gw}),m=u.clone();m.defines.HORIZONTAL_PASS=1;let g=new ii;g.setAttribute("position",new Fi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new zn(g,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xa;let f=this.type;this.render=function(E,_,v){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===Gg&&(Jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xa);let L=n.getRenderTarget(),T=n.getActiveCubeFace(),b=n.getActiveMipmapLevel(),D=n.state;D.setBlending(Rr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let F=f!==this.type;F&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(O=>O.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,O=E.length;I<O;I++){let H=E[I],z=H.shadow;if(z===void 0){Jt("WebGLShadowMap:",H,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let Q=z.getFrameExtents();s.multiply(Q),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/Q.x),s.x=r.x*Q.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/Q.y),s.y=r.y*Q.y,z.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Y,z.map===null||F===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===No){if(H.isPointLight){Jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new gi(s.x,s.y,{format:nr,type:Gi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),z.map.texture.name=H.name+".shadowMap",z.map.depthTexture=new ws(s.x,s.y,Vi),z.map.depthTexture.name=H.name+".shadowMapDepth",z.map.depthTexture.format=Ms,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=pn,z.map.depthTexture.magFilter=pn}else H.isPointLight?(z.map=new il(s.x),z.map.depthTexture=new Ca(s.x,ki)):(z.map=new gi(s.x,s.y),z.map.depthTexture=new ws(s.x,s.y,ki)),z.map.depthTexture.name=H.name+".shadowMap",z.map.depthTexture.format=Ms,this.type===Xa?(z.map.depthTexture.compareFunction=Y?$d:Yd,z.map.depthTexture.minFilter=jn,z.map.depthTexture.magFilter=jn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=pn,z.map.depthTexture.magFilter=pn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Z=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();H.isPointLight!==!0&&z.updateMatrices(H,v);let nt=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:v.layers;for(let lt=0;lt<Z;lt++){let ht=z.getCamera(lt);if(H.isPointLight){let tt=z.camera,mt=z.matrix,_t=H.distance||tt.far;_t!==tt.far&&(tt.far=_t,tt.updateProjectionMatrix()),el.setFromMatrixPosition(H.matrixWorld),tt.position.copy(el),ff.copy(tt.position),ff.add(Hw[lt]),tt.up.copy(Ww[lt]),tt.lookAt(ff),tt.updateMatrixWorld(),mt.makeTranslation(-el.x,-el.y,-el.z),X0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),z._frustum.setFromProjectionMatrix(X0,tt.coordinateSystem,tt.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,lt),n.clear();else{lt===0&&(n.setRenderTarget(z.map),n.clear());let tt=z.getViewport(lt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),D.viewport(o)}i=z.getFrustum(lt),S(_,v,ht,H,nt,this.type)}z.isPointLightShadow!==!0&&this.type===No&&M(z,v),z.needsUpdate=!1}f=this.type,p.needsUpdate=!1,n.setRenderTarget(L,T,b)};function M(E,_){let v=t.update(x);u.defines.VSM_SAMPLES!==E.blurSamples&&(u.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,u.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new gi(s.x,s.y,{format:nr,type:Gi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),u.uniforms.shadow_pass.value=E.map.depthTexture,u.uniforms.resolution.value.set(E.map.width,E.map.height),u.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,v,u,x,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,v,m,x,null)}function P(E,_,v,L){let T=null,b=v.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(b!==void 0)T=b;else if(T=v.isPointLight===!0?c:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=T.uuid,F=_.uuid,I=l[D];I===void 0&&(I={},l[D]=I);let O=I[F];O===void 0&&(O=T.clone(),I[F]=O,_.addEventListener("dispose",C)),T=O}if(T.visible=_.visible,T.wireframe=_.wireframe,L===No?T.side=_.shadowSide!==null?_.shadowSide:_.side:T.side=_.shadowSide!==null?_.shadowSide:d[_.side],T.alphaMap=_.alphaMap,T.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,T.map=_.map,T.clipShadows=_.clipShadows,T.clippingPlanes=_.clippingPlanes,T.clipIntersection=_.clipIntersection,T.displacementMap=_.displacementMap,T.displacementScale=_.displacementScale,T.displacementBias=_.displacementBias,T.wireframeLinewidth=_.wireframeLinewidth,T.linewidth=_.linewidth,v.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let D=n.properties.get(T);D.light=v}return T}function S(E,_,v,L,T,b){if(E.visible===!1)return;if(E.layers.test(T)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&b===No)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,E.matrixWorld);let I=t.update(E),O=E.material;if(Array.isArray(O)){let H=I.groups;for(let z=0,Q=H.length;z<Q;z++){let Y=H[z],Z=O[Y.materialIndex];if(Z&&Z.visible){let nt=P(E,Z,L,b);E.onBeforeShadow(n,E,_,v,I,nt,Y),n.renderBufferDirect(v,null,I,nt,E,Y),E.onAfterShadow(n,E,_,v,I,nt,Y)}}}else if(O.visible){let H=P(E,O,L,b);E.onBeforeShadow(n,E,_,v,I,H,null),n.renderBufferDirect(v,null,I,H,E,null),E.onAfterShadow(n,E,_,v,I,H,null)}}let F=E.children;for(let I=0,O=F.length;I<O;I++)S(F[I],_,v,L,T,b)}function C(E){E.target.removeEventListener("dispose",C);for(let v in l){let L=l[v],T=E.target.uuid;T in L&&(L[T].dispose(),delete L[T])}}}function qw(n,t){function e(){let k=!1,at=new Le,st=null,Et=new Le(0,0,0,0);return{setMask:function(yt){st!==yt&&!k&&(n.colorMask(yt,yt,yt,yt),st=yt)},setLocked:function(yt){k=yt},setClear:function(yt,bt,qt,te,ft){ft===!0&&(yt*=te,bt*=te,qt*=te),at.set(yt,bt,qt,te),Et.equals(at)===!1&&(n.clearColor(yt,bt,qt,te),Et.copy(at))},reset:function(){k=!1,st=null,Et.set(-1,0,0,0)}}}function i(){let k=!1,at=!1,st=null,Et=null,yt=null;return{setReversed:function(bt){if(at!==bt){let qt=t.get("EXT_clip_control");bt?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),at=bt;let te=yt;yt=null,this.setClear(te)}},getReversed:function(){return at},setTest:function(bt){bt?dt(n.DEPTH_TEST):Nt(n.DEPTH_TEST)},setMask:function(bt){st!==bt&&!k&&(n.depthMask(bt),st=bt)},setFunc:function(bt){if(at&&(bt=S0[bt]),Et!==bt){switch(bt){case ac:n.depthFunc(n.NEVER);break;case lc:n.depthFunc(n.ALWAYS);break;case cc:n.depthFunc(n.LESS);break;case wo:n.depthFunc(n.LEQUAL);break;case hc:n.depthFunc(n.EQUAL);break;case uc:n.depthFunc(n.GEQUAL);break;case dc:n.depthFunc(n.GREATER);break;case fc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=bt}},setLocked:function(bt){k=bt},setClear:function(bt){yt!==bt&&(yt=bt,at&&(bt=1-bt),n.clearDepth(bt))},reset:function(){k=!1,st=null,Et=null,yt=null,at=!1}}}function s(){let k=!1,at=null,st=null,Et=null,yt=null,bt=null,qt=null,te=null,ft=null;return{setTest:function(kt){k||(kt?dt(n.STENCIL_TEST):Nt(n.STENCIL_TEST))},setMask:function(kt){at!==kt&&!k&&(n.stencilMask(kt),at=kt)},setFunc:function(kt,ee,Rt){(st!==kt||Et!==ee||yt!==Rt)&&(n.stencilFunc(kt,ee,Rt),st=kt,Et=ee,yt=Rt)},setOp:function(kt,ee,Rt){(bt!==kt||qt!==ee||te!==Rt)&&(n.stencilOp(kt,ee,Rt),bt=kt,qt=ee,te=Rt)},setLocked:function(kt){k=kt},setClear:function(kt){ft!==kt&&(n.clearStencil(kt),ft=kt)},reset:function(){k=!1,at=null,st=null,Et=null,yt=null,bt=null,qt=null,te=null,ft=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,h={},d={},u={},m=new WeakMap,g=[],x=null,p=!1,f=null,M=null,P=null,S=null,C=null,E=null,_=null,v=new he(0,0,0),L=0,T=!1,b=null,D=null,F=null,I=null,O=null,H=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,Q=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Y)[1]),z=Q>=1):Y.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),z=Q>=2);let Z=null,nt={},lt=n.getParameter(n.SCISSOR_BOX),ht=n.getParameter(n.VIEWPORT),tt=new Le().fromArray(lt),mt=new Le().fromArray(ht);function _t(k,at,st,Et){let yt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(k,bt),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qt=0;qt<st;qt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(at,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,yt):n.texImage2D(at+qt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,yt);return bt}let ot={};ot[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),ot[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ot[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ot[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),dt(n.DEPTH_TEST),o.setFunc(wo),je(!1),Ee(Ed),dt(n.CULL_FACE),Se(Rr);function dt(k){h[k]!==!0&&(n.enable(k),h[k]=!0)}function Nt(k){h[k]!==!1&&(n.disable(k),h[k]=!1)}function $t(k,at){return u[k]!==at?(n.bindFramebuffer(k,at),u[k]=at,k===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=at),k===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=at),!0):!1}function Ot(k,at){let st=g,Et=!1;if(k){st=m.get(at),st===void 0&&(st=[],m.set(at,st));let yt=k.textures;if(st.length!==yt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,qt=yt.length;bt<qt;bt++)st[bt]=n.COLOR_ATTACHMENT0+bt;st.length=yt.length,Et=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,Et=!0);Et&&n.drawBuffers(st)}function se(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let ae={[Cr]:n.FUNC_ADD,[Wg]:n.FUNC_SUBTRACT,[Xg]:n.FUNC_REVERSE_SUBTRACT};ae[qg]=n.MIN,ae[Yg]=n.MAX;let Xt={[$g]:n.ZERO,[Zg]:n.ONE,[Jg]:n.SRC_COLOR,[Cd]:n.SRC_ALPHA,[n0]:n.SRC_ALPHA_SATURATE,[t0]:n.DST_COLOR,[Kg]:n.DST_ALPHA,[jg]:n.ONE_MINUS_SRC_COLOR,[Pd]:n.ONE_MINUS_SRC_ALPHA,[e0]:n.ONE_MINUS_DST_COLOR,[Qg]:n.ONE_MINUS_DST_ALPHA,[i0]:n.CONSTANT_COLOR,[s0]:n.ONE_MINUS_CONSTANT_COLOR,[r0]:n.CONSTANT_ALPHA,[o0]:n.ONE_MINUS_CONSTANT_ALPHA};function Se(k,at,st,Et,yt,bt,qt,te,ft,kt){if(k===Rr){p===!0&&(Nt(n.BLEND),p=!1);return}if(p===!1&&(dt(n.BLEND),p=!0),k!==Hg){if(k!==f||kt!==T){if((M!==Cr||C!==Cr)&&(n.blendEquation(n.FUNC_ADD),M=Cr,C=Cr),kt)switch(k){case Uo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Td:n.blendFunc(n.ONE,n.ONE);break;case Ad:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",k);break}else switch(k){case Uo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Td:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ad:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Rd:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",k);break}P=null,S=null,E=null,_=null,v.set(0,0,0),L=0,f=k,T=kt}return}yt=yt||at,bt=bt||st,qt=qt||Et,(at!==M||yt!==C)&&(n.blendEquationSeparate(ae[at],ae[yt]),M=at,C=yt),(st!==P||Et!==S||bt!==E||qt!==_)&&(n.blendFuncSeparate(Xt[st],Xt[Et],Xt[bt],Xt[qt]),P=st,S=Et,E=bt,_=qt),(te.equals(v)===!1||ft!==L)&&(n.blendColor(te.r,te.g,te.b,ft),v.copy(te),L=ft),f=k,T=!1}function Ce(k,at){k.side===ns?Nt(n.CULL_FACE):dt(n.CULL_FACE);let st=k.side===ti;at&&(st=!st),je(st),k.blending===Uo&&k.transparent===!1?Se(Rr):Se(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Et=k.stencilWrite;a.setTest(Et),Et&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Me(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?dt(n.SAMPLE_ALPHA_TO_COVERAGE):Nt(n.SAMPLE_ALPHA_TO_COVERAGE)}function je(k){b!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),b=k)}function Ee(k){k!==kg?(dt(n.CULL_FACE),k!==D&&(k===Ed?n.cullFace(n.BACK):k===Vg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Nt(n.CULL_FACE),D=k}function Mn(k){k!==F&&(z&&n.lineWidth(k),F=k)}function Me(k,at,st){k?(dt(n.POLYGON_OFFSET_FILL),(I!==at||O!==st)&&(I=at,O=st,o.getReversed()&&(at=-at,st=-st),n.polygonOffset(at,st))):Nt(n.POLYGON_OFFSET_FILL)}function mn(k){k?dt(n.SCISSOR_TEST):Nt(n.SCISSOR_TEST)}function Ke(k){k===void 0&&(k=n.TEXTURE0+H-1),Z!==k&&(n.activeTexture(k),Z=k)}function on(k,at,st){st===void 0&&(Z===null?st=n.TEXTURE0+H-1:st=Z);let Et=nt[st];Et===void 0&&(Et={type:void 0,texture:void 0},nt[st]=Et),(Et.type!==k||Et.texture!==at)&&(Z!==st&&(n.activeTexture(st),Z=st),n.bindTexture(k,at||ot[k]),Et.type=k,Et.texture=at)}function V(){let k=nt[Z];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ct(){try{n.compressedTexImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function le(){try{n.texSubImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function wt(){try{n.texSubImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function Be(){try{n.compressedTexSubImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function Wt(){try{n.compressedTexSubImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function Zt(){try{n.texStorage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function N(){try{n.texStorage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function pt(k){return d[k]!==void 0?d[k]:n.getParameter(k)}function ct(k,at){d[k]!==at&&(n.pixelStorei(k,at),d[k]=at)}function vt(k){tt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),tt.copy(k))}function St(k){mt.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),mt.copy(k))}function it(k,at){let st=l.get(at);st===void 0&&(st=new WeakMap,l.set(at,st));let Et=st.get(k);Et===void 0&&(Et=n.getUniformBlockIndex(at,k.name),n.uniformBlockBinding(at,Et,Et),st.set(k,Et))}function rt(k,at,st){let yt=l.get(at).get(k);c[yt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,yt,st),c[yt]=st)}function xt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Z=null,nt={},u={},c={},m=new WeakMap,g=[],x=null,p=!1,f=null,M=null,P=null,S=null,C=null,E=null,_=null,v=new he(0,0,0),L=0,T=!1,b=null,D=null,F=null,I=null,O=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:dt,disable:Nt,bindFramebuffer:$t,drawBuffers:Ot,useProgram:se,setBlending:Se,setMaterial:Ce,setFlipSided:je,setCullFace:Ee,setLineWidth:Mn,setPolygonOffset:Me,setScissorTest:mn,activeTexture:Ke,bindTexture:on,unbindTexture:V,compressedTexImage2D:Ct,compressedTexImage3D:jt,texImage2D:w,texImage3D:$,pixelStorei:ct,getParameter:pt,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:Zt,texStorage3D:N,texSubImage2D:le,texSubImage3D:wt,compressedTexSubImage2D:Be,compressedTexSubImage3D:Wt,scissor:vt,viewport:St,reset:xt}}function Yw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Kt,h=new WeakMap,d=new Set,u,m=new WeakMap,g=new Set,x=new FinalizationRegistry(N=>g.delete(N)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(N,w){return p?new OffscreenCanvas(N,w):ya("canvas")}function M(N,w,$){let pt=1,ct=Zt(N);if((ct.width>$||ct.height>$)&&(pt=$/Math.max(ct.width,ct.height)),pt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let vt=Math.floor(pt*ct.width),St=Math.floor(pt*ct.height);u===void 0&&(u=f(vt,St));let it=w?f(vt,St):u;return it.width=vt,it.height=St,it.getContext("2d").drawImage(N,0,0,vt,St),Jt("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+vt+"x"+St+")."),it}else return"data"in N&&Jt("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),N;return N}function P(N){return N.generateMipmaps}function S(N){n.generateMipmap(N)}function C(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(N,w,$,pt,ct,vt=!1){if(N!==null){if(n[N]!==void 0)return n[N];Jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let St;pt&&(St=t.get("EXT_texture_norm16"),St||Jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=w;if(w===n.RED&&($===n.FLOAT&&(it=n.R32F),$===n.HALF_FLOAT&&(it=n.R16F),$===n.UNSIGNED_BYTE&&(it=n.R8),$===n.UNSIGNED_SHORT&&St&&(it=St.R16_EXT),$===n.SHORT&&St&&(it=St.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.R8UI),$===n.UNSIGNED_SHORT&&(it=n.R16UI),$===n.UNSIGNED_INT&&(it=n.R32UI),$===n.BYTE&&(it=n.R8I),$===n.SHORT&&(it=n.R16I),$===n.INT&&(it=n.R32I)),w===n.RG&&($===n.FLOAT&&(it=n.RG32F),$===n.HALF_FLOAT&&(it=n.RG16F),$===n.UNSIGNED_BYTE&&(it=n.RG8),$===n.UNSIGNED_SHORT&&St&&(it=St.RG16_EXT),$===n.SHORT&&St&&(it=St.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RG8UI),$===n.UNSIGNED_SHORT&&(it=n.RG16UI),$===n.UNSIGNED_INT&&(it=n.RG32UI),$===n.BYTE&&(it=n.RG8I),$===n.SHORT&&(it=n.RG16I),$===n.INT&&(it=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RGB8UI),$===n.UNSIGNED_SHORT&&(it=n.RGB16UI),$===n.UNSIGNED_INT&&(it=n.RGB32UI),$===n.BYTE&&(it=n.RGB8I),$===n.SHORT&&(it=n.RGB16I),$===n.INT&&(it=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),$===n.UNSIGNED_INT&&(it=n.RGBA32UI),$===n.BYTE&&(it=n.RGBA8I),$===n.SHORT&&(it=n.RGBA16I),$===n.INT&&(it=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&St&&(it=St.RGB16_EXT),$===n.SHORT&&St&&(it=St.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),w===n.RGBA){let rt=vt?xa:ve.getTransfer(ct);$===n.FLOAT&&(it=n.RGBA32F),$===n.HALF_FLOAT&&(it=n.RGBA16F),$===n.UNSIGNED_BYTE&&(it=rt===Ie?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&St&&(it=St.RGBA16_EXT),$===n.SHORT&&St&&(it=St.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(N,w){let $;return N?w===null||w===ki||w===Ir?$=n.DEPTH24_STENCIL8:w===Vi?$=n.DEPTH32F_STENCIL8:w===Oo&&($=n.DEPTH24_STENCIL8,Jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===ki||w===Ir?$=n.DEPTH_COMPONENT24:w===Vi?$=n.DEPTH_COMPONENT32F:w===Oo&&($=n.DEPTH_COMPONENT16),$}function v(N,w){return P(N)===!0||N.isFramebufferTexture&&N.minFilter!==pn&&N.minFilter!==jn?Math.log2(Math.max(w.width,w.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?w.mipmaps.length:1}function L(N){let w=new WeakRef(N);i.get(N).__ref=w,g.add(w),x.register(N,w,w)}function T(N){let w=i.get(N).__ref;w!==void 0&&(g.delete(w),x.unregister(w))}function b(N){F(N.target)}function D(N){I(N.target)}function F(N){N.removeEventListener("dispose",b),T(N),H(N),N.isVideoTexture&&h.delete(N),N.isHTMLTexture&&d.delete(N)}function I(N){N.removeEventListener("dispose",D),T(N),Q(N)}function O(){for(let N of g){let w=N.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):F(w))}g.clear(),d.clear()}function H(N){let w=i.get(N);if(w.__webglInit===void 0)return;let $=N.source,pt=m.get($);if(pt){let ct=pt[w.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&z(N),Object.keys(pt).length===0&&m.delete($)}i.remove(N)}function z(N){let w=i.get(N);n.deleteTexture(w.__webglTexture);let $=N.source,pt=m.get($);delete pt[w.__cacheKey],o.memory.textures--}function Q(N){let w=i.get(N);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=N.depthTexture;if($&&$.renderTarget===N&&F($),N.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(w.__webglFramebuffer[ct]))for(let vt=0;vt<w.__webglFramebuffer[ct].length;vt++)n.deleteFramebuffer(w.__webglFramebuffer[ct][vt]);else n.deleteFramebuffer(w.__webglFramebuffer[ct]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[ct])}else{if(Array.isArray(w.__webglFramebuffer))for(let ct=0;ct<w.__webglFramebuffer.length;ct++)n.deleteFramebuffer(w.__webglFramebuffer[ct]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ct=0;ct<w.__webglColorRenderbuffer.length;ct++)w.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[ct]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let pt=N.textures;for(let ct=0,vt=pt.length;ct<vt;ct++){let St=i.get(pt[ct]);St.__webglTexture&&(n.deleteTexture(St.__webglTexture),o.memory.textures--),i.remove(pt[ct])}i.remove(N)}let Y=0;function Z(){Y=0}function nt(){return Y}function lt(N){Y=N}function ht(){let N=Y;return N>=s.maxTextures&&Jt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,N}function tt(N){let w=[];return w.push(N.wrapS),w.push(N.wrapT),w.push(N.wrapR||0),w.push(N.magFilter),w.push(N.minFilter),w.push(N.anisotropy),w.push(N.internalFormat),w.push(N.format),w.push(N.type),w.push(N.generateMipmaps),w.push(N.mipmapsAutoUpdate),w.push(N.premultiplyAlpha),w.push(N.flipY),w.push(N.unpackAlignment),w.push(N.colorSpace),w.join()}function mt(N,w){let $=i.get(N);if(N.isVideoTexture&&Be(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&$.__version!==N.version){let pt=N.image;if(pt===null)Jt("WebGLRenderer: Texture marked for update but no image data found.");else if(pt.complete===!1)Jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ce($,N,w);return}}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function _t(N,w){let $=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Ce($,N,w);return}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function ot(N,w){let $=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Ce($,N,w);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function dt(N,w){let $=i.get(N);if(N.version>0&&$.__version!==N.version){je($,N,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let Nt={[pc]:n.REPEAT,[ts]:n.CLAMP_TO_EDGE,[mc]:n.MIRRORED_REPEAT},$t={[pn]:n.NEAREST,[c0]:n.NEAREST_MIPMAP_NEAREST,[qa]:n.NEAREST_MIPMAP_LINEAR,[jn]:n.LINEAR,[qc]:n.LINEAR_MIPMAP_NEAREST,[Es]:n.LINEAR_MIPMAP_LINEAR},Ot={[f0]:n.NEVER,[Zd]:n.ALWAYS,[p0]:n.LESS,[Yd]:n.LEQUAL,[m0]:n.EQUAL,[$d]:n.GEQUAL,[g0]:n.GREATER,[_0]:n.NOTEQUAL};function se(N,w){if(w.type===Vi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===jn||w.magFilter===qc||w.magFilter===qa||w.magFilter===Es||w.minFilter===jn||w.minFilter===qc||w.minFilter===qa||w.minFilter===Es)&&Jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,Nt[w.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,Nt[w.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,Nt[w.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,$t[w.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,$t[w.minFilter]),w.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Ot[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===pn||w.minFilter!==qa&&w.minFilter!==Es||w.type===Vi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(N,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function ae(N,w){let $=!1;N.__webglInit===void 0&&(N.__webglInit=!0,w.addEventListener("dispose",b),L(w));let pt=w.source,ct=m.get(pt);ct===void 0&&(ct={},m.set(pt,ct));let vt=tt(w);if(vt!==N.__cacheKey){ct[vt]===void 0&&(ct[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ct[vt].usedTimes++;let St=ct[N.__cacheKey];St!==void 0&&(ct[N.__cacheKey].usedTimes--,St.usedTimes===0&&z(w)),N.__cacheKey=vt,N.__webglTexture=ct[vt].texture}return $}function Xt(N,w,$){return Math.floor(Math.floor(N/$)/w)}function Se(N,w,$,pt){let vt=N.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,pt,w.data);else{vt.sort((k,at)=>k.start-at.start);let St=0;for(let k=1;k<vt.length;k++){let at=vt[St],st=vt[k],Et=at.start+at.count,yt=Xt(st.start,w.width,4),bt=Xt(at.start,w.width,4);st.start<=Et+1&&yt===bt&&Xt(st.start+st.count-1,w.width,4)===yt?at.count=Math.max(at.count,st.start+st.count-at.start):(++St,vt[St]=st)}vt.length=St+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),xt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,at=vt.length;k<at;k++){let st=vt[k],Et=Math.floor(st.start/4),yt=Math.ceil(st.count/4),bt=Et%w.width,qt=Math.floor(Et/w.width),te=yt,ft=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,qt),e.texSubImage2D(n.TEXTURE_2D,0,bt,qt,te,ft,$,pt,w.data)}N.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,xt)}}function Ce(N,w,$){let pt=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(pt=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(pt=n.TEXTURE_3D);let ct=ae(N,w),vt=w.source;e.bindTexture(pt,N.__webglTexture,n.TEXTURE0+$);let St=i.get(vt);if(vt.version!==St.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ft=ve.getPrimaries(ve.workingColorSpace),kt=w.colorSpace===As?null:ve.getPrimaries(w.colorSpace),ee=w.colorSpace===As||ft===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let rt=M(w.image,!1,s.maxTextureSize);rt=Wt(w,rt);let xt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),at=E(w.internalFormat,xt,k,w.normalized,w.colorSpace,w.isVideoTexture);se(pt,w);let st,Et=w.mipmaps,yt=w.isVideoTexture!==!0,bt=St.__version===void 0||ct===!0,qt=vt.dataReady,te=v(w,rt);if(w.isDepthTexture)at=_(w.format===Ts,w.type),bt&&(yt?e.texStorage2D(n.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,k,null));else if(w.isDataTexture)if(Et.length>0){yt&&bt&&e.texStorage2D(n.TEXTURE_2D,te,at,Et[0].width,Et[0].height);for(let ft=0,kt=Et.length;ft<kt;ft++)st=Et[ft],yt?qt&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,xt,k,st.data):e.texImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,xt,k,st.data);w.generateMipmaps=!1}else yt?(bt&&e.texStorage2D(n.TEXTURE_2D,te,at,rt.width,rt.height),qt&&Se(w,rt,xt,k)):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,k,rt.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){yt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,at,Et[0].width,Et[0].height,rt.depth);for(let ft=0,kt=Et.length;ft<kt;ft++)if(st=Et[ft],w.format!==Hi)if(xt!==null)if(yt){if(qt)if(w.layerUpdates.size>0){let ee=of(st.width,st.height,w.format,w.type);for(let Rt of w.layerUpdates){let ue=st.data.subarray(Rt*ee/st.data.BYTES_PER_ELEMENT,(Rt+1)*ee/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,Rt,st.width,st.height,1,xt,ue)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,xt,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,st.data,0,0);else Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else yt?qt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,xt,k,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,xt,k,st.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{yt&&bt&&e.texStorage2D(n.TEXTURE_2D,te,at,Et[0].width,Et[0].height);for(let ft=0,kt=Et.length;ft<kt;ft++)st=Et[ft],w.format!==Hi?xt!==null?yt?qt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,xt,st.data):e.compressedTexImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,st.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):yt?qt&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,xt,k,st.data):e.texImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,xt,k,st.data)}else if(w.isDataArrayTexture)if(yt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,at,rt.width,rt.height,rt.depth),qt)if(w.layerUpdates.size>0){let ft=of(rt.width,rt.height,w.format,w.type);for(let kt of w.layerUpdates){let ee=rt.data.subarray(kt*ft/rt.data.BYTES_PER_ELEMENT,(kt+1)*ft/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,rt.width,rt.height,1,xt,k,ee)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,xt,k,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,xt,k,rt.data);else if(w.isData3DTexture)yt?(bt&&e.texStorage3D(n.TEXTURE_3D,te,at,rt.width,rt.height,rt.depth),qt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,xt,k,rt.data)):e.texImage3D(n.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,xt,k,rt.data);else if(w.isFramebufferTexture){if(bt)if(yt)e.texStorage2D(n.TEXTURE_2D,te,at,rt.width,rt.height);else{let ft=rt.width,kt=rt.height;for(let ee=0;ee<te;ee++)e.texImage2D(n.TEXTURE_2D,ee,at,ft,kt,0,xt,k,null),ft>>=1,kt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ft=n.canvas;if(ft.hasAttribute("layoutsubtree")||ft.setAttribute("layoutsubtree","true"),rt.parentNode!==ft){ft.appendChild(rt),d.add(w),ft.onpaint=kt=>{let ee=kt.changedElements;for(let Rt of d)ee.includes(Rt.image)&&(Rt.needsUpdate=!0)},ft.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let ee=n.RGBA,Rt=n.RGBA,ue=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ee,Rt,ue,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(yt&&bt){let ft=Zt(Et[0]);e.texStorage2D(n.TEXTURE_2D,te,at,ft.width,ft.height)}for(let ft=0,kt=Et.length;ft<kt;ft++)st=Et[ft],yt?qt&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,xt,k,st):e.texImage2D(n.TEXTURE_2D,ft,at,xt,k,st);w.generateMipmaps=!1}else if(yt){if(bt){let ft=Zt(rt);e.texStorage2D(n.TEXTURE_2D,te,at,ft.width,ft.height)}qt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,xt,k,rt)}else e.texImage2D(n.TEXTURE_2D,0,at,xt,k,rt);P(w)&&w.mipmapsAutoUpdate===!0&&S(pt),St.__version=vt.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function je(N,w,$){if(w.image.length!==6)return;let pt=ae(N,w),ct=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+$);let vt=i.get(ct);if(ct.version!==vt.__version||pt===!0){e.activeTexture(n.TEXTURE0+$);let St=ve.getPrimaries(ve.workingColorSpace),it=w.colorSpace===As?null:ve.getPrimaries(w.colorSpace),rt=w.colorSpace===As||St===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let xt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,at=[];for(let Rt=0;Rt<6;Rt++)!xt&&!k?at[Rt]=M(w.image[Rt],!0,s.maxCubemapSize):at[Rt]=k?w.image[Rt].image:w.image[Rt],at[Rt]=Wt(w,at[Rt]);let st=at[0],Et=r.convert(w.format,w.colorSpace),yt=r.convert(w.type),bt=E(w.internalFormat,Et,yt,w.normalized,w.colorSpace),qt=w.isVideoTexture!==!0,te=vt.__version===void 0||pt===!0,ft=ct.dataReady,kt=v(w,st);se(n.TEXTURE_CUBE_MAP,w);let ee;if(w.isDepthTexture){if(bt=_(w.format===Ts,w.type),te)if(qt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,st.width,st.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,st.width,st.height,0,Et,yt,null)}else if(xt){qt&&te&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,st.width,st.height);for(let Rt=0;Rt<6;Rt++){ee=at[Rt].mipmaps;for(let ue=0;ue<ee.length;ue++){let Ge=ee[ue];w.format!==Hi?Et!==null?qt?ft&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Ge.width,Ge.height,Et,Ge.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,bt,Ge.width,Ge.height,0,Ge.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Ge.width,Ge.height,Et,yt,Ge.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,bt,Ge.width,Ge.height,0,Et,yt,Ge.data)}}}else{if(ee=w.mipmaps,qt&&te){ee.length>0&&kt++;let Rt=Zt(at[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(k){qt?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,at[Rt].width,at[Rt].height,Et,yt,at[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,at[Rt].width,at[Rt].height,0,Et,yt,at[Rt].data);for(let ue=0;ue<ee.length;ue++){let Vn=ee[ue].image[Rt].image;qt?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Vn.width,Vn.height,Et,yt,Vn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,bt,Vn.width,Vn.height,0,Et,yt,Vn.data)}}else{qt?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,yt,at[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,Et,yt,at[Rt]);for(let ue=0;ue<ee.length;ue++){let Ge=ee[ue];qt?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Et,yt,Ge.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,bt,Et,yt,Ge.image[Rt])}}}P(w)&&w.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),vt.__version=ct.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function Ee(N,w,$,pt,ct,vt){let St=r.convert($.format,$.colorSpace),it=r.convert($.type),rt=E($.internalFormat,St,it,$.normalized,$.colorSpace),xt=i.get(w),k=i.get($);if(k.__renderTarget=w,!xt.__hasExternalTextures){let at=Math.max(1,w.width>>vt),st=Math.max(1,w.height>>vt);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,vt,rt,at,st,w.depth,0,St,it,null):e.texImage2D(ct,vt,rt,at,st,0,St,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,N),wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,ct,k.__webglTexture,0,le(w)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,pt,ct,k.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mn(N,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,N),w.depthBuffer){let pt=w.depthTexture,ct=pt&&pt.isDepthTexture?pt.type:null,vt=_(w.stencilBuffer,ct),St=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(w),vt,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(w),vt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,vt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,N)}else{let pt=w.textures;for(let ct=0;ct<pt.length;ct++){let vt=pt[ct],St=r.convert(vt.format,vt.colorSpace),it=r.convert(vt.type),rt=E(vt.internalFormat,St,it,vt.normalized,vt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(w),rt,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(w),rt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,rt,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Me(N,w,$){let pt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,N),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(w.depthTexture);ct.__renderTarget=w;let vt=pt?w.depthTexture.image[0]:w.depthTexture.image;(!ct.__webglTexture||vt.width!==w.width||vt.height!==w.height)&&(vt.width=w.width,vt.height=w.height,w.depthTexture.needsUpdate=!0),pt?dt(w.depthTexture,0):mt(w.depthTexture,0);let St=ct.__webglTexture,it=le(w),rt=pt?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,xt=w.depthTexture.format===Ts?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ms)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xt,rt,St,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,xt,rt,St,0);else if(w.depthTexture.format===Ts)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xt,rt,St,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,xt,rt,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(N){let w=i.get(N),$=N.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==N.depthTexture){let pt=N.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),pt){let ct=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,pt.removeEventListener("dispose",ct)};pt.addEventListener("dispose",ct),w.__depthDisposeCallback=ct}w.__boundDepthTexture=pt}if(N.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let pt=0;pt<6;pt++)Me(w.__webglFramebuffer[pt],N,pt);else N.texture.mipmaps.length>0?Me(w.__webglFramebuffer[0],N,0):Me(w.__webglFramebuffer,N,0);else if($){w.__webglDepthbuffer=[];for(let pt=0;pt<6;pt++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[pt]),w.__webglDepthbuffer[pt]===void 0)w.__webglDepthbuffer[pt]=n.createRenderbuffer(),Mn(w.__webglDepthbuffer[pt],N,!1);else{let ct=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=w.__webglDepthbuffer[pt];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Mn(w.__webglDepthbuffer,N,!1);else{let ct=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ke(N,w,$){let pt=i.get(N);w!==void 0&&Ee(pt.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&mn(N)}function on(N){let w=N.texture,$=i.get(N),pt=i.get(w);N.addEventListener("dispose",D),L(N);let ct=N.textures,vt=N.isWebGLCubeRenderTarget===!0,St=ct.length>1;if(St||(pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture()),pt.__version=w.version,o.memory.textures++),vt){$.__webglFramebuffer=[];for(let it=0;it<6;it++)if(w.mipmaps.length>0){$.__webglFramebuffer[it]=[];for(let rt=0;rt<w.mipmaps.length;rt++)$.__webglFramebuffer[it][rt]=n.createFramebuffer()}else $.__webglFramebuffer[it]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let it=0;it<w.mipmaps.length;it++)$.__webglFramebuffer[it]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(St)for(let it=0,rt=ct.length;it<rt;it++){let xt=i.get(ct[it]);xt.__webglTexture===void 0&&(xt.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&wt(N)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let it=0;it<ct.length;it++){let rt=ct[it];$.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[it]);let xt=r.convert(rt.format,rt.colorSpace),k=r.convert(rt.type),at=E(rt.internalFormat,xt,k,rt.normalized,rt.colorSpace,N.isXRRenderTarget===!0),st=le(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,at,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,$.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Mn($.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,pt.__webglTexture),se(n.TEXTURE_CUBE_MAP,w);for(let it=0;it<6;it++)if(w.mipmaps.length>0)for(let rt=0;rt<w.mipmaps.length;rt++)Ee($.__webglFramebuffer[it][rt],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else Ee($.__webglFramebuffer[it],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);P(w)?S(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(St){for(let it=0,rt=ct.length;it<rt;it++){let xt=ct[it],k=i.get(xt),at=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(at=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(at,k.__webglTexture),se(at,xt),Ee($.__webglFramebuffer,N,xt,n.COLOR_ATTACHMENT0+it,at,0),P(xt)&&S(at)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(it=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,pt.__webglTexture),se(it,w),w.mipmaps.length>0)for(let rt=0;rt<w.mipmaps.length;rt++)Ee($.__webglFramebuffer[rt],N,w,n.COLOR_ATTACHMENT0,it,rt);else Ee($.__webglFramebuffer,N,w,n.COLOR_ATTACHMENT0,it,0);P(w)?S(it):w.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&mn(N)}function V(N){let w=N.textures;for(let $=0,pt=w.length;$<pt;$++){let ct=w[$];if(P(ct)&&ct.mipmapsAutoUpdate===!0){let vt=C(N),St=i.get(ct).__webglTexture;e.bindTexture(vt,St),S(vt),e.unbindTexture()}}}let Ct=[];function jt(N){if(N.samples>0){if(wt(N)===!1){let w=N.textures,$=N.width,pt=N.height,ct=n.COLOR_BUFFER_BIT,vt=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(N),it=w.length>1;if(it)for(let xt=0;xt<w.length;xt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let xt=0;xt<w.length;xt++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let k=i.get(w[xt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,pt,0,0,$,pt,ct,n.NEAREST),c===!0&&(Ct.length=0,Ct.push(n.COLOR_ATTACHMENT0+xt),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Ct.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let xt=0;xt<w.length;xt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.RENDERBUFFER,St.__webglColorRenderbuffer[xt]);let k=i.get(w[xt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&c){let w=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function le(N){return Math.min(s.maxSamples,N.samples)}function wt(N){let w=i.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Be(N){let w=o.render.frame;h.get(N)!==w&&(h.set(N,w),N.update())}function Wt(N,w){let $=N.colorSpace,pt=N.format,ct=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||$!==_a&&$!==As&&(ve.getTransfer($)===Ie?(pt!==Hi||ct!==si)&&Jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",$)),w}function Zt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(l.width=N.naturalWidth||N.width,l.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(l.width=N.displayWidth,l.height=N.displayHeight):(l.width=N.width,l.height=N.height),l}this.allocateTextureUnit=ht,this.resetTextureUnits=Z,this.getTextureUnits=nt,this.setTextureUnits=lt,this.setTexture2D=mt,this.setTexture2DArray=_t,this.setTexture3D=ot,this.setTextureCube=dt,this.rebindTextures=Ke,this.setupRenderTarget=on,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=Ee,this.useMultisampledRTT=wt,this.dispose=O}function $w(n,t){function e(i,s=As){let r,o=ve.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===$c)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Gd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Hd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===kd)return n.BYTE;if(i===Vd)return n.SHORT;if(i===Oo)return n.UNSIGNED_SHORT;if(i===Yc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===Gi)return n.HALF_FLOAT;if(i===Wd)return n.ALPHA;if(i===Xd)return n.RGB;if(i===Hi)return n.RGBA;if(i===Ms)return n.DEPTH_COMPONENT;if(i===Ts)return n.DEPTH_STENCIL;if(i===qd)return n.RED;if(i===Jc)return n.RED_INTEGER;if(i===nr)return n.RG;if(i===jc)return n.RG_INTEGER;if(i===Kc)return n.RGBA_INTEGER;if(i===Ya||i===$a||i===Za||i===Ja)if(o===Ie)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ya)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ya)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Za)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ja)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Qc||i===th||i===eh||i===nh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Qc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===eh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===nh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ih||i===sh||i===rh||i===oh||i===ah||i===ja||i===lh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ih||i===sh)return o===Ie?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===rh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===oh)return r.COMPRESSED_R11_EAC;if(i===ah)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ja)return r.COMPRESSED_RG11_EAC;if(i===lh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ch||i===hh||i===uh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh||i===yh||i===vh||i===Sh||i===Mh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ch)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===hh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===uh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===dh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===fh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ph)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===mh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===gh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===_h)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===xh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===yh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===vh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Sh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Mh)return o===Ie?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===bh||i===wh||i===Eh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===bh)return o===Ie?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===wh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Eh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Th||i===Ah||i===Ka||i===Rh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Th)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ah)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ka)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ir?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var Zw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Jw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,vf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Pa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ei({vertexShader:Zw,fragmentShader:Jw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new zn(new Ar(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Sf=class extends Oi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,d=null,u=null,m=null,g=null,x=typeof XRWebGLBinding<"u",p=new vf,f={},M=e.getContextAttributes(),P=null,S=null,C=[],E=[],_=new Kt,v=null,L=null,T=new Zn;T.viewport=new Le;let b=new Zn;b.viewport=new Le;let D=[T,b],F=new Gc,I=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Co,C[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Co,C[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Co,C[tt]=mt),mt.getHandSpace()};function H(tt){let mt=E.indexOf(tt.inputSource);if(mt===-1)return;let _t=C[mt];_t!==void 0&&(_t.update(tt.inputSource,tt.frame,l||o),_t.dispatchEvent({type:tt.type,data:tt.inputSource}))}function z(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",Q);for(let tt=0;tt<C.length;tt++){let mt=E[tt];mt!==null&&(E[tt]=null,C[tt].disconnect(mt))}I=null,O=null,p.reset();for(let tt in f)delete f[tt];if(t.setRenderTarget(P),m=null,u=null,d=null,s=null,S=null,ht.stop(),i.isPresenting=!1,t.setPixelRatio(v),t.setSize(_.width,_.height,!1),L!==null){let tt=L.camera;tt.fov=L.fov,tt.zoom=L.zoom,tt.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(tt){l=tt},this.getBaseLayer=function(){return u!==null?u:m},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(P=t.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",z),s.addEventListener("inputsourceschange",Q),M.xrCompatible!==!0&&await e.makeXRCompatible(),v=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,ot=null,dt=null;M.depth&&(dt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=M.stencil?Ts:Ms,ot=M.stencil?Ir:ki);let Nt={colorFormat:e.RGBA8,depthFormat:dt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Nt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),S=new gi(u.textureWidth,u.textureHeight,{format:Hi,type:si,depthTexture:new ws(u.textureWidth,u.textureHeight,ot,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _t={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),S=new gi(m.framebufferWidth,m.framebufferHeight,{format:Hi,type:si,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ht.setContext(s),ht.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function Q(tt){for(let mt=0;mt<tt.removed.length;mt++){let _t=tt.removed[mt],ot=E.indexOf(_t);ot>=0&&(E[ot]=null,C[ot].disconnect(_t))}for(let mt=0;mt<tt.added.length;mt++){let _t=tt.added[mt],ot=E.indexOf(_t);if(ot===-1){for(let Nt=0;Nt<C.length;Nt++)if(Nt>=E.length){E.push(_t),ot=Nt;break}else if(E[Nt]===null){E[Nt]=_t,ot=Nt;break}if(ot===-1)break}let dt=C[ot];dt&&dt.connect(_t)}}function Y(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,_t=tt.far;p.texture!==null&&(p.depthNear>0&&(mt=p.depthNear),p.depthFar>0&&(_t=p.depthFar)),F.near=b.near=T.near=mt,F.far=b.far=T.far=_t,(I!==F.near||O!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),I=F.near,O=F.far),F.layers.mask=tt.layers.mask|6,T.layers.mask=F.layers.mask&-5,b.layers.mask=F.layers.mask&-3;let ot=tt.parent,dt=F.cameras;Y(F,ot);for(let Nt=0;Nt<dt.length;Nt++)Y(dt[Nt],ot);F.projectionMatrix.copy(T.projectionMatrix),F.projectionMatrixInverse.copy(T.projectionMatrixInverse),L===null&&tt.isPerspectiveCamera&&(L={camera:tt,fov:tt.fov,zoom:tt.zoom}),Z(tt,F,ot)};function Z(tt,mt,_t){_t===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(_t.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Ao*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(u===null&&m===null))return c},this.setFoveation=function(tt){c=tt,u!==null&&(u.fixedFoveation=tt),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=tt)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(F)},this.getCameraTexture=function(tt){return f[tt]};let nt=null;function lt(tt,mt){if(h=mt.getViewerPose(l||o),g=mt,h!==null){let _t=h.views;m!==null&&(t.setRenderTargetFramebuffer(S,m.framebuffer),t.setRenderTarget(S));let ot=!1;_t.length!==F.cameras.length&&(F.cameras.length=0,ot=!0);for(let Ot=0;Ot<_t.length;Ot++){let se=_t[Ot],ae=null;if(m!==null)ae=m.getViewport(se);else{let Se=d.getViewSubImage(u,se);ae=Se.viewport,Ot===0&&(t.setRenderTargetTextures(S,Se.colorTexture,Se.depthStencilTexture),t.setRenderTarget(S))}let Xt=D[Ot];Xt===void 0&&(Xt=new Zn,Xt.layers.enable(Ot),Xt.viewport=new Le,D[Ot]=Xt),Xt.matrix.fromArray(se.transform.matrix),Xt.matrix.decompose(Xt.position,Xt.quaternion,Xt.scale),Xt.projectionMatrix.fromArray(se.projectionMatrix),Xt.projectionMatrixInverse.copy(Xt.projectionMatrix).invert(),Xt.viewport.set(ae.x,ae.y,ae.width,ae.height),Ot===0&&(F.matrix.copy(Xt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),ot===!0&&F.cameras.push(Xt)}let dt=s.enabledFeatures;if(dt&&dt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let Ot=d.getDepthInformation(_t[0]);Ot&&Ot.isValid&&Ot.texture&&p.init(Ot,s.renderState)}if(dt&&dt.includes("camera-access")&&x){t.state.unbindTexture(),d=i.getBinding();for(let Ot=0;Ot<_t.length;Ot++){let se=_t[Ot].camera;if(se){let ae=f[se];ae||(ae=new Pa,f[se]=ae);let Xt=d.getCameraImage(se);ae.sourceTexture=Xt}}}}for(let _t=0;_t<C.length;_t++){let ot=E[_t],dt=C[_t];ot!==null&&dt!==void 0&&dt.update(ot,mt,l||o)}nt&&nt(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let ht=new q0;ht.setAnimationLoop(lt),this.setAnimationLoop=function(tt){nt=tt},this.dispose=function(){}}},jw=new Fe,n_=new re;n_.set(-1,0,0,0,1,0,0,0,1);function Kw(n,t){function e(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function i(p,f){f.color.getRGB(p.fogColor.value,nf(n)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,M,P,S){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(p,f):f.isMeshLambertMaterial?(r(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(p,f),d(p,f)):f.isMeshPhongMaterial?(r(p,f),h(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(p,f),u(p,f),f.isMeshPhysicalMaterial&&m(p,f,S)):f.isMeshMatcapMaterial?(r(p,f),g(p,f)):f.isMeshDepthMaterial?r(p,f):f.isMeshDistanceMaterial?(r(p,f),x(p,f)):f.isMeshNormalMaterial?r(p,f):f.isLineBasicMaterial?(o(p,f),f.isLineDashedMaterial&&a(p,f)):f.isPointsMaterial?c(p,f,M,P):f.isSpriteMaterial?l(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,e(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,e(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,e(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===ti&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,e(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===ti&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,e(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,e(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);let M=t.get(f),P=M.envMap,S=M.envMapRotation;P&&(p.envMap.value=P,p.envMapRotation.value.setFromMatrix4(jw.makeRotationFromEuler(S)).transpose(),P.isCubeTexture&&P.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(n_),p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,p.aoMapTransform))}function o(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,e(f.map,p.mapTransform))}function a(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function c(p,f,M,P){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*M,p.scale.value=P*.5,f.map&&(p.map.value=f.map,e(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,e(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function l(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,e(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,e(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function h(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function d(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function u(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function m(p,f,M){p.ior.value=f.ior,f.diffuseRoughness>0&&(p.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=f.diffuseRoughnessMap,e(f.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===ti&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.retroreflectivity>0&&(p.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,f){f.matcap&&(p.matcap.value=f.matcap)}function x(p,f){let M=t.get(f).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Qw(n,t,e,i){let s={},r={};function o(M,P){let S=P.program;i.uniformBlockBinding(M,S,s[M.id])}function a(M,P){let S=s[M.id];S===void 0&&(g(M),S=c(M),s[M.id]=S,M.addEventListener("dispose",p));let C=P.program;i.updateUBOMapping(M,C);let E=t.render.frame;r[M.id]!==E&&(l(M),r[M.id]=E)}function c(M){let P=n.createBuffer(),S=M.__size,C=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,P),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),P}function l(M){let P=s[M.id],S=M.uniforms,C=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,P);for(let E=0,_=S.length;E<_;E++){let v=S[E];if(Array.isArray(v))for(let L=0,T=v.length;L<T;L++)h(v[L],E,L,C);else h(v,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(M,P,S,C){if(u(M,P,S,C)===!0){let E=M.__offset,_=M.value;if(Array.isArray(_)){let v=0;for(let L=0;L<_.length;L++){let T=_[L],b=x(T,!0);d(T,M.__data,v),v+=b.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,M.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,M.__data)}}function d(M,P,S){typeof M=="number"||typeof M=="boolean"?P[S]=M:M.isMatrix3?(P[S]=M.elements[0],P[S+1]=M.elements[1],P[S+2]=M.elements[2],P[S+3]=0,P[S+4]=M.elements[3],P[S+5]=M.elements[4],P[S+6]=M.elements[5],P[S+7]=0,P[S+8]=M.elements[6],P[S+9]=M.elements[7],P[S+10]=M.elements[8],P[S+11]=0):ArrayBuffer.isView(M)?P.set(M.subarray(0,P.length-S),S):M.toArray(P,S)}function u(M,P,S,C){let E=M.value,_=P+"_"+S;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let v=C[_],L=!1;for(let T=0;T<E.length;T++)m(E[T],v,T)===!0&&(L=!0);return L}return m(E,C,_)}function m(M,P,S){if(P[S]===void 0)return typeof M=="number"||typeof M=="boolean"?P[S]=M:ArrayBuffer.isView(M)?P[S]=M.slice():P[S]=M.clone(),!0;{let C=P[S];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return P[S]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function g(M){let P=M.uniforms,S=0,C=16;for(let _=0,v=P.length;_<v;_++){let L=Array.isArray(P[_])?P[_]:[P[_]];for(let T=0,b=L.length;T<b;T++){let D=L[T],F=Array.isArray(D.value)?D.value:[D.value],I=Array.isArray(P[_])||Array.isArray(D.value),O=S;for(let z=0,Q=F.length;z<Q;z++){let Y=F[z],Z=x(Y,I),nt=S%C,lt=nt%Z.boundary,ht=nt+lt;S+=lt,ht!==0&&C-ht<Z.storage&&(S+=C-ht),z===0&&(O=S),S+=Z.storage}let H=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new H((S-O)/Float32Array.BYTES_PER_ELEMENT),D.__offset=O}}let E=S%C;return E>0&&(S+=C-E),M.__size=S,M.__cache={},this}function x(M,P){let S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=16,S.storage=48):M.isMatrix4?(S.boundary=16,S.storage=64):M.isTexture?Jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(S.boundary=16,S.storage=M.byteLength):Jt("WebGLRenderer: Unsupported uniform value type.",M),P===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(M){let P=M.target;P.removeEventListener("dispose",p),n.deleteBuffer(s[P.id]),delete s[P.id],delete r[P.id]}function f(){for(let M in s)n.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:f}}var tE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ss=null;function eE(){return ss===null&&(ss=new Mc(tE,16,16,nr,Gi),ss.name="DFG_LUT",ss.minFilter=jn,ss.magFilter=jn,ss.wrapS=ts,ss.wrapT=ts,ss.generateMipmaps=!1,ss.needsUpdate=!0),ss}var Nh=class{constructor(t={}){let{canvas:e=x0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:m=si}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=m,p=new Set([Kc,jc,Jc]),f=new Set([si,ki,Oo,Ir,$c,Zc]),M=new Uint32Array(4),P=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],v=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=is,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,b=!1,D=null,F=null,I=null,O=null;this._outputColorSpace=$n;let H=0,z=0,Q=null,Y=-1,Z=null,nt=new Le,lt=new Le,ht=null,tt=new he(0),mt=0,_t=e.width,ot=e.height,dt=1,Nt=null,$t=null,Ot=new Le(0,0,_t,ot),se=new Le(0,0,_t,ot),ae=!1,Xt=new Ys,Se=new bc,Ce=!1,je=!1,Ee=new Fe,Mn=new q,Me=new Le,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ke=!1;function on(){return Q===null?dt:1}let V=i;function Ct(R,W){return e.getContext(R,W)}let jt,le,wt,Be,Wt,Zt,N,w,$,pt,ct,vt,St,it,rt,xt,k,at,st,Et,yt,bt,qt;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),V===null){let W="webgl2";if(V=Ct(W,R),V===null)throw Ct(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),ie("WebGLRenderer: "+R.message),R}function te(){jt=new d1(V),jt.init(),yt=new $w(V,jt),le=new e1(V,jt,t,yt),wt=new qw(V,jt),le.reversedDepthBuffer&&u&&wt.buffers.depth.setReversed(!0),F=V.createFramebuffer(),I=V.createFramebuffer(),O=V.createFramebuffer(),Be=new m1(V),Wt=new Lw,Zt=new Yw(V,jt,wt,Wt,le,yt,Be),N=new u1(T),w=new _S(V),bt=new Qb(V,w),$=new f1(V,w,Be,bt),pt=new _1(V,$,w,bt,Be),at=new g1(V,le,Zt),rt=new n1(Wt),ct=new Iw(T,N,jt,le,bt,rt),vt=new Kw(T,Wt),St=new Nw,it=new kw(jt),k=new Kb(T,N,wt,pt,g,c),xt=new Xw(T,pt,le),qt=new Qw(V,Be,le,wt),st=new t1(V,jt,Be),Et=new p1(V,jt,Be),Be.programs=ct.programs,T.capabilities=le,T.extensions=jt,T.properties=Wt,T.renderLists=St,T.shadowMap=xt,T.state=wt,T.info=Be}x!==si&&(L=new y1(x,e.width,e.height,a,s,r));let ft=new Sf(T,V);this.xr=ft,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let R=jt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=jt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return dt},this.setPixelRatio=function(R){R!==void 0&&(dt=R,this.setSize(_t,ot,!1))},this.getSize=function(R){return R.set(_t,ot)},this.setSize=function(R,W,et=!0){if(ft.isPresenting){Jt("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=R,ot=W,e.width=Math.floor(R*dt),e.height=Math.floor(W*dt),et===!0&&(e.style.width=R+"px",e.style.height=W+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(_t*dt,ot*dt).floor()},this.setDrawingBufferSize=function(R,W,et){_t=R,ot=W,dt=et,e.width=Math.floor(R*et),e.height=Math.floor(W*et),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(x===si){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){Jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(nt)},this.getViewport=function(R){return R.copy(Ot)},this.setViewport=function(R,W,et,J){R.isVector4?Ot.set(R.x,R.y,R.z,R.w):Ot.set(R,W,et,J),wt.viewport(nt.copy(Ot).multiplyScalar(on()).round())},this.getScissor=function(R){return R.copy(se)},this.setScissor=function(R,W,et,J){R.isVector4?se.set(R.x,R.y,R.z,R.w):se.set(R,W,et,J),wt.scissor(lt.copy(se).multiplyScalar(on()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(R){wt.setScissorTest(ae=R)},this.setOpaqueSort=function(R){Nt=R},this.setTransparentSort=function(R){$t=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,et=!0){let J=0;if(R){let j=!1;if(Q!==null){let Tt=Q.texture.format;j=p.has(Tt)}if(j){let Tt=Q.texture.type,Lt=f.has(Tt),At=k.getClearColor(),Dt=k.getClearAlpha(),Gt=At.r,ne=At.g,pe=At.b;Lt?(M[0]=Gt,M[1]=ne,M[2]=pe,M[3]=Dt,V.clearBufferuiv(V.COLOR,0,M)):(P[0]=Gt,P[1]=ne,P[2]=pe,P[3]=Dt,V.clearBufferiv(V.COLOR,0,P))}else J|=V.COLOR_BUFFER_BIT}W&&(J|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(J|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&V.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),D=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),k.dispose(),St.dispose(),it.dispose(),Zt.dispose(),Wt.dispose(),N.dispose(),pt.dispose(),$.dispose(),bt.dispose(),qt.dispose(),ct.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",ll),ft.removeEventListener("sessionend",Wi),ls.stop()};function kt(R){R.preventDefault(),va("WebGLRenderer: Context Lost."),b=!0}function ee(){va("WebGLRenderer: Context Restored."),b=!1;let R=Be.autoReset,W=xt.enabled,et=xt.autoUpdate,J=xt.needsUpdate,j=xt.type;te(),Be.autoReset=R,xt.enabled=W,xt.autoUpdate=et,xt.needsUpdate=J,xt.type=j}function Rt(R){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ue(R){let W=R.target;W.removeEventListener("dispose",ue),Ge(W)}function Ge(R){Vn(R),Wt.remove(R)}function Vn(R){let W=Wt.get(R).programs;W!==void 0&&(W.forEach(function(et){ct.releaseProgram(et)}),R.isShaderMaterial&&ct.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,et,J,j,Tt){W===null&&(W=mn);let Lt=j.isMesh&&j.matrixWorld.determinantAffine()<0,At=Xo(R,W,et,J,j);wt.setMaterial(J,Lt);let Dt=et.index,Gt=1;if(J.wireframe===!0){if(Dt=$.getWireframeAttribute(et),Dt===void 0)return;Gt=2}let ne=et.drawRange,pe=et.attributes.position,Vt=ne.start*Gt,me=(ne.start+ne.count)*Gt;Tt!==null&&(Vt=Math.max(Vt,Tt.start*Gt),me=Math.min(me,(Tt.start+Tt.count)*Gt)),Dt!==null?(Vt=Math.max(Vt,0),me=Math.min(me,Dt.count)):pe!=null&&(Vt=Math.max(Vt,0),me=Math.min(me,pe.count));let Je=me-Vt;if(Je<0||Je===1/0)return;bt.setup(j,J,At,et,Dt);let De,Ne=st;if(Dt!==null&&(De=w.get(Dt),Ne=Et,Ne.setIndex(De)),j.isMesh)J.wireframe===!0?(wt.setLineWidth(J.wireframeLinewidth*on()),Ne.setMode(V.LINES)):Ne.setMode(V.TRIANGLES);else if(j.isLine){let gn=J.linewidth;gn===void 0&&(gn=1),wt.setLineWidth(gn*on()),j.isLineSegments?Ne.setMode(V.LINES):j.isLineLoop?Ne.setMode(V.LINE_LOOP):Ne.setMode(V.LINE_STRIP)}else j.isPoints?Ne.setMode(V.POINTS):j.isSprite&&Ne.setMode(V.TRIANGLES);if(j.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Ne.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let gn=j._multiDrawStarts,Bt=j._multiDrawCounts,an=j._multiDrawCount,_e=Dt?w.get(Dt).bytesPerElement:1,hs=Wt.get(J).currentProgram.getUniforms();for(let ln=0;ln<an;ln++)hs.setValue(V,"_gl_DrawID",ln),Ne.render(gn[ln]/_e,Bt[ln])}else if(j.isInstancedMesh)Ne.renderInstances(Vt,Je,j.count);else if(et.isInstancedBufferGeometry){let gn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Bt=Math.min(et.instanceCount,gn);Ne.renderInstances(Vt,Je,Bt)}else Ne.render(Vt,Je)};function Go(R,W,et,J){D!==null&&R.isNodeMaterial&&D.setObject(J,R),Ce===!0&&rt.setState(R,et,!1),R.transparent===!0&&R.side===ns&&R.forceSinglePass===!1?(R.side=ti,R.needsUpdate=!0,Xi(R,W,J),R.side=er,R.needsUpdate=!0,Xi(R,W,J),R.side=ns):Xi(R,W,J)}this.compile=function(R,W,et=null){et===null&&(et=R),D!==null&&D.renderStart(R,W,et),E=it.get(et),E.init(W),v.push(E),et.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),R!==et&&R.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),E.setupLights(),D!==null&&D.updateLights(E.state.lightsArray),je=this.localClippingEnabled,Ce=rt.init(this.clippingPlanes,je),Ce===!0&&rt.setGlobalState(this.clippingPlanes,W),D!==null&&xt.render(E.state.shadowsArray,et,W);let J=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Tt=j.material;if(Tt)if(Array.isArray(Tt))for(let Lt=0;Lt<Tt.length;Lt++){let At=Tt[Lt];Go(At,et,W,j),J.add(At)}else Go(Tt,et,W,j),J.add(Tt)}),E=v.pop(),D!==null&&D.renderEnd(),J},this.compileAsync=function(R,W,et=null){let J=this.compile(R,W,et);return new Promise(j=>{function Tt(){if(J.forEach(function(Lt){let Dt=Wt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&J.delete(Lt)}),J.size===0){j(R);return}setTimeout(Tt,10)}jt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Fr=null;function $h(R){Fr&&Fr(R)}function ll(){ls.stop()}function Wi(){ls.start()}let ls=new q0;ls.setAnimationLoop($h),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(R){Fr=R,ft.setAnimationLoop(R),R===null?ls.stop():ls.start()},ft.addEventListener("sessionstart",ll),ft.addEventListener("sessionend",Wi),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(b===!0)return;D!==null&&D.renderStart(R,W);let et=ft.enabled===!0&&ft.isPresenting===!0,J=L!==null&&(Q===null||et)&&L.begin(T,Q);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(W),W=ft.getCamera()),R.isScene===!0&&R.onBeforeRender(T,R,W,Q),E=it.get(R,v.length),E.init(W),E.state.textureUnits=Zt.getTextureUnits(),v.push(E),Ee.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Se.setFromArrayCamera(W):Xt.setFromProjectionMatrix(Ee,wi,W.reversedDepth),je=this.localClippingEnabled,Ce=rt.init(this.clippingPlanes,je),C=St.get(R,_.length),C.init(),_.push(C),this.info.render.frame++,ft.enabled===!0&&ft.isPresenting===!0){let Lt=T.xr.getDepthSensingMesh();Lt!==null&&cs(Lt,W,-1/0,T.sortObjects)}cs(R,W,0,T.sortObjects),C.finish(),D!==null&&D.updateLights(E.state.lightsArray),T.sortObjects===!0&&C.sort(Nt,$t),Ke=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,Ke&&k.addToRenderList(C,R),this.info.autoReset===!0&&this.info.reset(),Ce===!0&&rt.beginShadows();let j=E.state.shadowsArray;if(xt.render(j,R,W),Ce===!0&&rt.endShadows(),(J&&L.hasRenderPass())===!1){let Lt=C.opaque,At=C.transmissive;if(E.setupLights(),W.isArrayCamera){let Dt=W.cameras;if(At.length>0)for(let Gt=0,ne=Dt.length;Gt<ne;Gt++){let pe=Dt[Gt];Ti(Lt,At,R,pe)}Ke&&k.render(R);for(let Gt=0,ne=Dt.length;Gt<ne;Gt++){let pe=Dt[Gt];Ho(C,R,pe,pe.viewport)}}else At.length>0&&Ti(Lt,At,R,W),Ke&&k.render(R),Ho(C,R,W)}Q!==null&&z===0&&(Zt.updateMultisampleRenderTarget(Q),Zt.updateRenderTargetMipmap(Q)),J&&L.end(T),R.isScene===!0&&R.onAfterRender(T,R,W),bt.resetDefaultState(),Y=-1,Z=null,v.pop(),v.length>0?(E=v[v.length-1],Zt.setTextureUnits(E.state.textureUnits),Ce===!0&&rt.setGlobalState(T.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,D!==null&&D.renderEnd()};function cs(R,W,et,J){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)et=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)E.pushLight(R),R.castShadow&&E.pushShadow(R);else if(R.isSprite){let Lt=W.isArrayCamera?Se:Xt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){J&&Me.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ee);let At=pt.update(R),Dt=R.material;Dt.visible&&C.push(R,At,Dt,et,Me.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let Lt=W.isArrayCamera?Se:Xt;if(!R.frustumCulled||R.intersectsFrustum(Lt)){let At=pt.update(R),Dt=R.material;if(J&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Me.copy(R.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),Me.copy(At.boundingSphere.center)),Me.applyMatrix4(R.matrixWorld).applyMatrix4(Ee)),Array.isArray(Dt)){let Gt=At.groups;for(let ne=0,pe=Gt.length;ne<pe;ne++){let Vt=Gt[ne],me=Dt[Vt.materialIndex];me&&me.visible&&C.push(R,At,me,et,Me.z,Vt,W)}}else Dt.visible&&C.push(R,At,Dt,et,Me.z,null,W)}}}let Tt=R.children;for(let Lt=0,At=Tt.length;Lt<At;Lt++)cs(Tt[Lt],W,et,J)}function Ho(R,W,et,J){let{opaque:j,transmissive:Tt,transparent:Lt}=R;E.setupLightsView(et),Ce===!0&&rt.setGlobalState(T.clippingPlanes,et),J&&wt.viewport(nt.copy(J)),j.length>0&&Qe(j,W,et),Tt.length>0&&Qe(Tt,W,et),Lt.length>0&&Qe(Lt,W,et),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ti(R,W,et,J){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[J.id]===void 0){let Vt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[J.id]=new gi(1,1,{generateMipmaps:!0,type:Vt?Gi:si,minFilter:Es,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let Tt=E.state.transmissionRenderTarget[J.id],Lt=J.viewport||nt;Tt.setSize(Lt.z*T.transmissionResolutionScale,Lt.w*T.transmissionResolutionScale);let At=T.getRenderTarget(),Dt=T.getActiveCubeFace(),Gt=T.getActiveMipmapLevel();T.setRenderTarget(Tt),T.getClearColor(tt),mt=T.getClearAlpha(),mt<1&&T.setClearColor(16777215,.5),T.clear(),Ke&&k.render(et);let ne=T.toneMapping;T.toneMapping=is;let pe=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),E.setupLightsView(J),Ce===!0&&rt.setGlobalState(T.clippingPlanes,J),Qe(R,et,J),Zt.updateMultisampleRenderTarget(Tt),Zt.updateRenderTargetMipmap(Tt),jt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let me=0,Je=W.length;me<Je;me++){let De=W[me],{object:Ne,geometry:gn,material:Bt,group:an}=De;if(Bt.side===ns&&Ne.layers.test(J.layers)){let _e=Bt.side;Bt.side=ti,Bt.needsUpdate=!0,sn(Ne,et,J,gn,Bt,an),Bt.side=_e,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Zt.updateMultisampleRenderTarget(Tt),Zt.updateRenderTargetMipmap(Tt))}T.setRenderTarget(At,Dt,Gt),T.setClearColor(tt,mt),pe!==void 0&&(J.viewport=pe),T.toneMapping=ne}function Qe(R,W,et){let J=W.isScene===!0?W.overrideMaterial:null;for(let j=0,Tt=R.length;j<Tt;j++){let Lt=R[j],{object:At,geometry:Dt,group:Gt}=Lt,ne=Lt.material;ne.allowOverride===!0&&J!==null&&(ne=J),At.layers.test(et.layers)&&sn(At,W,et,Dt,ne,Gt)}}function sn(R,W,et,J,j,Tt){D!==null&&j.isNodeMaterial&&D.setObject(R,j),R.onBeforeRender(T,W,et,J,j,Tt),R.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(T,W,et,J,R,Tt),j.transparent===!0&&j.side===ns&&j.forceSinglePass===!1?(j.side=ti,j.needsUpdate=!0,T.renderBufferDirect(et,W,J,j,R,Tt),j.side=er,j.needsUpdate=!0,T.renderBufferDirect(et,W,J,j,R,Tt),j.side=ns):T.renderBufferDirect(et,W,J,j,R,Tt),R.onAfterRender(T,W,et,J,j,Tt)}function rn(R){let W=0;for(let et of R)et.texture!==null&&W++;return W}function Xi(R,W,et){W.isScene!==!0&&(W=mn);let J=Wt.get(R),j=E.state.lights,Tt=E.state.shadowsArray,Lt=j.state.version,At=ct.getParameters(R,j.state,Tt,W,et,E.state.lightProbeGridArray),Dt=ct.getProgramCacheKey(At),Gt=J.programs;J.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,J.fog=W.fog;let ne=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;J.envMap=N.get(R.envMap||J.environment,ne),J.envMapRotation=J.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,Gt===void 0&&(R.addEventListener("dispose",ue),Gt=new Map,J.programs=Gt,J.programVariants=new Map);let pe=Gt.get(Dt);if(pe!==void 0){if(J.currentProgram===pe&&J.lightsStateVersion===Lt)return Wo(R,At),pe}else At.uniforms=ct.getUniforms(R),D!==null&&R.isNodeMaterial&&D.build(R,et,At),R.onBeforeCompile(At,T),pe=ct.acquireProgram(At,Dt),Gt.set(Dt,pe),J.uniforms=At.uniforms;let Vt=J.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),Wo(R,At),J.needsLights=Ps(R),J.lightsStateVersion=Lt,J.needsLights&&(Vt.ambientLightColor.value=j.state.ambient,Vt.lightProbe.value=j.state.probe,Vt.sunLights.value=j.state.sun,Vt.sunLightShadows.value=j.state.sunShadow,Vt.directionalLights.value=j.state.directional,Vt.directionalLightShadows.value=j.state.directionalShadow,Vt.spotLights.value=j.state.spot,Vt.spotLightShadows.value=j.state.spotShadow,Vt.rectAreaLights.value=j.state.rectArea,Vt.ltc_1.value=j.state.rectAreaLTC1,Vt.ltc_2.value=j.state.rectAreaLTC2,Vt.pointLights.value=j.state.point,Vt.pointLightShadows.value=j.state.pointShadow,Vt.hemisphereLights.value=j.state.hemi,Vt.sunShadowMatrix.value=j.state.sunShadowMatrix,Vt.sunShadowCascade.value=j.state.sunShadowCascade,Vt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Vt.spotLightMatrix.value=j.state.spotLightMatrix,Vt.spotLightMap.value=j.state.spotLightMap,Vt.pointShadowMatrix.value=j.state.pointShadowMatrix),J.numLightProbeGrids=rn(E.state.lightProbeGridArray),J.currentProgram=pe,J.uniformsList=null,pe}function oi(R,W,et,J,j){let Tt=Wt.get(R),Lt=Tt.currentProgram.id+","+J+","+j,At=Tt.programVariants.get(Lt);return At===void 0?(At=Xi(R,W,et),Tt.programVariants.set(Lt,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=J,Tt.toneMapping=j),At}function Cs(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=Bo.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function Wo(R,W){let et=Wt.get(R);et.outputColorSpace=W.outputColorSpace,et.batching=W.batching,et.batchingColor=W.batchingColor,et.instancing=W.instancing,et.instancingColor=W.instancingColor,et.instancingMorph=W.instancingMorph,et.skinning=W.skinning,et.morphTargets=W.morphTargets,et.morphNormals=W.morphNormals,et.morphColors=W.morphColors,et.morphTargetsCount=W.morphTargetsCount,et.numClippingPlanes=W.numClippingPlanes,et.numIntersection=W.numClipIntersection,et.vertexAlphas=W.vertexAlphas,et.vertexTangents=W.vertexTangents,et.toneMapping=W.toneMapping}function Xo(R,W,et,J,j){W.isScene!==!0&&(W=mn),Zt.resetTextureUnits();let Tt=W.fog,Lt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?W.environment:null,At=Q===null?T.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:ve.workingColorSpace,Dt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Gt=N.get(J.envMap||Lt,Dt),ne=J.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,pe=!!et.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Vt=!!et.morphAttributes.position,me=!!et.morphAttributes.normal,Je=!!et.morphAttributes.color,De=is;J.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(De=T.toneMapping);let Ne=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,gn=Ne!==void 0?Ne.length:0,Bt=Wt.get(J),an=E.state.lights;if(Ce===!0&&(je===!0||R!==Z)){let Ue=R===Z&&J.id===Y;rt.setState(J,R,Ue)}let _e=!1,hs=!1;J.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==an.state.version||j.isBatchedMesh&&Bt.batching===!1||!j.isBatchedMesh&&Bt.batching===!0||j.isBatchedMesh&&Bt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Bt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Bt.instancing===!1||!j.isInstancedMesh&&Bt.instancing===!0||j.isSkinnedMesh&&Bt.skinning===!1||!j.isSkinnedMesh&&Bt.skinning===!0||j.isInstancedMesh&&Bt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Bt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Bt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Bt.instancingMorph===!1&&j.morphTexture!==null||Bt.envMap!==Gt||J.fog===!0&&Bt.fog!==Tt||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==rt.numPlanes||Bt.numIntersection!==rt.numIntersection)||Bt.vertexAlphas!==ne||Bt.vertexTangents!==pe||Bt.morphTargets!==Vt||Bt.morphNormals!==me||Bt.morphColors!==Je||Bt.morphTargetsCount!==gn||Bt.numLightProbeGrids!==rn(E.state.lightProbeGridArray)?_e=!0:(Bt.outputColorSpace!==At||Bt.toneMapping!==De)&&(hs=!0):(_e=!0,Bt.__version=J.version);let ln=Bt.currentProgram;(_e===!0||hs===!0)&&(ln=hs===!0?oi(J,W,j,At,De):Xi(J,W,j),D&&J.isNodeMaterial&&D.onUpdateProgram(J,ln,Bt));let zr=!1,qi=!1,us=!1,de=ln.getUniforms(),tn=Bt.uniforms;if(wt.useProgram(ln.program)&&(zr=!0,qi=!0,us=!0),J.id!==Y&&(Y=J.id,qi=!0),zr||Z!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),de.setValue(V,"projectionMatrix",R.projectionMatrix),de.setValue(V,"viewMatrix",R.matrixWorldInverse);let cn=de.map.cameraPosition;cn!==void 0&&cn.setValue(V,Mn.setFromMatrixPosition(R.matrixWorld)),le.logarithmicDepthBuffer&&de.setValue(V,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&de.setValue(V,"isOrthographic",R.isOrthographicCamera===!0),Z!==R&&(Z=R,qi=!0,us=!0)}if(Bt.needsLights&&(an.state.sunShadowMap.length>0&&de.setValue(V,"sunShadowMap",an.state.sunShadowMap,Zt),an.state.directionalShadowMap.length>0&&de.setValue(V,"directionalShadowMap",an.state.directionalShadowMap,Zt),an.state.spotShadowMap.length>0&&de.setValue(V,"spotShadowMap",an.state.spotShadowMap,Zt),an.state.pointShadowMap.length>0&&de.setValue(V,"pointShadowMap",an.state.pointShadowMap,Zt)),j.isSkinnedMesh){de.setOptional(V,j,"bindMatrix"),de.setOptional(V,j,"bindMatrixInverse");let Ue=j.skeleton;Ue&&(Ue.boneTexture===null&&Ue.computeBoneTexture(),de.setValue(V,"boneTexture",Ue.boneTexture,Zt))}j.isBatchedMesh&&(de.setOptional(V,j,"batchingTexture"),de.setValue(V,"batchingTexture",j._matricesTexture,Zt),de.setOptional(V,j,"batchingIdTexture"),de.setValue(V,"batchingIdTexture",j._indirectTexture,Zt),de.setOptional(V,j,"batchingColorTexture"),j._colorsTexture!==null&&de.setValue(V,"batchingColorTexture",j._colorsTexture,Zt));let Gn=et.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&at.update(j,et,ln),(qi||Bt.receiveShadow!==j.receiveShadow)&&(Bt.receiveShadow=j.receiveShadow,de.setValue(V,"receiveShadow",j.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&W.environment!==null&&(tn.envMapIntensity.value=W.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=eE()),qi){if(de.setValue(V,"toneMappingExposure",T.toneMappingExposure),Bt.needsLights&&Or(tn,us),Tt&&J.fog===!0&&vt.refreshFogUniforms(tn,Tt),vt.refreshMaterialUniforms(tn,J,dt,ot,E.state.transmissionRenderTarget[R.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Ue=S,cn=0;for(let Un of E.state.lightProbeGridArray)Un.texture!==null&&(Ue.textures[cn]=Un.texture,Ue.min[cn]=Un.boundingBox.min,Ue.max[cn]=Un.boundingBox.max,Ue.resolution[cn]=Un.resolution,cn++);for(let Un in Ue)Ue[Un].length=cn;tn.probesSH.value=Ue.textures,tn.probesMin.value=Ue.min,tn.probesMax.value=Ue.max,tn.probesResolution.value=Ue.resolution}Bo.upload(V,Cs(Bt),tn,Zt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Bo.upload(V,Cs(Bt),tn,Zt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&de.setValue(V,"center",j.center),de.setValue(V,"modelViewMatrix",j.modelViewMatrix),de.setValue(V,"normalMatrix",j.normalMatrix),de.setValue(V,"modelMatrix",j.matrixWorld),J.uniformsGroups!==void 0){let Ue=J.uniformsGroups;for(let cn=0,Un=Ue.length;cn<Un;cn++){let cl=Ue[cn];qt.update(cl,ln),qt.bind(cl,ln)}}return ln}function Or(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Ps(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(R,W,et){let J=Wt.get(R);J.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Wt.get(R.texture).__webglTexture=W,Wt.get(R.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:et,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let et=Wt.get(R);et.__webglFramebuffer=W,et.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,et=0){Q=R,H=W,z=et;let J=null,j=!1,Tt=!1;if(R){let At=Wt.get(R);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(V.FRAMEBUFFER,At.__webglFramebuffer),nt.copy(R.viewport),lt.copy(R.scissor),ht=R.scissorTest,wt.viewport(nt),wt.scissor(lt),wt.setScissorTest(ht),Y=-1;return}else if(At.__webglFramebuffer===void 0)Zt.setupRenderTarget(R);else if(At.__hasExternalTextures)Zt.rebindTextures(R,Wt.get(R.texture).__webglTexture,Wt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ne=R.depthTexture;if(At.__boundDepthTexture!==ne){if(ne!==null&&Wt.has(ne)&&(R.width!==ne.image.width||R.height!==ne.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Zt.setupDepthRenderbuffer(R)}}let Dt=R.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(Tt=!0);let Gt=Wt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Gt[W])?J=Gt[W][et]:J=Gt[W],j=!0):R.samples>0&&Zt.useMultisampledRTT(R)===!1?J=Wt.get(R).__webglMultisampledFramebuffer:Array.isArray(Gt)?J=Gt[et]:J=Gt,nt.copy(R.viewport),lt.copy(R.scissor),ht=R.scissorTest}else nt.copy(Ot).multiplyScalar(dt).floor(),lt.copy(se).multiplyScalar(dt).floor(),ht=ae;if(et!==0&&(J=F),wt.bindFramebuffer(V.FRAMEBUFFER,J)&&wt.drawBuffers(R,J),wt.viewport(nt),wt.scissor(lt),wt.setScissorTest(ht),j){let At=Wt.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+W,At.__webglTexture,et)}else if(Tt){let At=W;for(let Dt=0;Dt<R.textures.length;Dt++){let Gt=Wt.get(R.textures[Dt]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Dt,Gt.__webglTexture,et,At)}}else if(R!==null&&et!==0){let At=Wt.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,At.__webglTexture,et)}Y=-1};function Br(R){let W=Wt.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=le.textureFormatReadable(R.format),W.__typeReadable=le.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,et,J,j,Tt,Lt,At=0){if(!(R&&R.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){wt.bindFramebuffer(V.FRAMEBUFFER,Dt);try{let Gt=R.textures[At],ne=Gt.format,pe=Gt.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+At);let Vt=Br(Gt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-J&&et>=0&&et<=R.height-j&&V.readPixels(W,et,J,j,yt.convert(ne),yt.convert(pe),Tt)}finally{let Gt=Q!==null?Wt.get(Q).__webglFramebuffer:null;wt.bindFramebuffer(V.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(R,W,et,J,j,Tt,Lt,At=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(W>=0&&W<=R.width-J&&et>=0&&et<=R.height-j){wt.bindFramebuffer(V.FRAMEBUFFER,Dt);let Gt=R.textures[At],ne=Gt.format,pe=Gt.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+At);let Vt=Br(Gt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,me),V.bufferData(V.PIXEL_PACK_BUFFER,Tt.byteLength,V.STREAM_READ),V.readPixels(W,et,J,j,yt.convert(ne),yt.convert(pe),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Je=Q!==null?Wt.get(Q).__webglFramebuffer:null;wt.bindFramebuffer(V.FRAMEBUFFER,Je);let De=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await v0(V,De,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,me),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Tt),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(me),V.deleteSync(De),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,et=0){let J=Math.pow(2,-et),j=Math.floor(R.image.width*J),Tt=Math.floor(R.image.height*J),Lt=W!==null?W.x:0,At=W!==null?W.y:0;Zt.setTexture2D(R,0),V.copyTexSubImage2D(V.TEXTURE_2D,et,0,0,Lt,At,j,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(R,W,et=null,J=null,j=0,Tt=0){let Lt,At,Dt,Gt,ne,pe,Vt,me,Je,De=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(et!==null)Lt=et.max.x-et.min.x,At=et.max.y-et.min.y,Dt=et.isBox3?et.max.z-et.min.z:1,Gt=et.min.x,ne=et.min.y,pe=et.isBox3?et.min.z:0;else{let de=Math.pow(2,-j);Lt=Math.floor(De.width*de),At=Math.floor(De.height*de),R.isDataArrayTexture?Dt=De.depth:R.isData3DTexture?Dt=Math.floor(De.depth*de):Dt=1,Gt=0,ne=0,pe=0}J!==null?(Vt=J.x,me=J.y,Je=J.z):(Vt=0,me=0,Je=0);let Ne=yt.convert(W.format),gn=yt.convert(W.type),Bt;W.isData3DTexture?(Zt.setTexture3D(W,0),Bt=V.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Zt.setTexture2DArray(W,0),Bt=V.TEXTURE_2D_ARRAY):(Zt.setTexture2D(W,0),Bt=V.TEXTURE_2D),wt.activeTexture(V.TEXTURE0),wt.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,W.flipY),wt.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),wt.pixelStorei(V.UNPACK_ALIGNMENT,W.unpackAlignment);let an=wt.getParameter(V.UNPACK_ROW_LENGTH),_e=wt.getParameter(V.UNPACK_IMAGE_HEIGHT),hs=wt.getParameter(V.UNPACK_SKIP_PIXELS),ln=wt.getParameter(V.UNPACK_SKIP_ROWS),zr=wt.getParameter(V.UNPACK_SKIP_IMAGES);wt.pixelStorei(V.UNPACK_ROW_LENGTH,De.width),wt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,De.height),wt.pixelStorei(V.UNPACK_SKIP_PIXELS,Gt),wt.pixelStorei(V.UNPACK_SKIP_ROWS,ne),wt.pixelStorei(V.UNPACK_SKIP_IMAGES,pe);let qi=R.isDataArrayTexture||R.isData3DTexture,us=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let de=Wt.get(R),tn=Wt.get(W),Gn=Wt.get(de.__renderTarget),Ue=Wt.get(tn.__renderTarget);wt.bindFramebuffer(V.READ_FRAMEBUFFER,Gn.__webglFramebuffer),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let cn=0;cn<Dt;cn++)qi&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Wt.get(R).__webglTexture,j,pe+cn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Wt.get(W).__webglTexture,Tt,Je+cn)),V.blitFramebuffer(Gt,ne,Gt+Lt,ne+At,Vt,me,Vt+Lt,me+At,V.DEPTH_BUFFER_BIT,V.NEAREST);wt.bindFramebuffer(V.READ_FRAMEBUFFER,null),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||Wt.has(R)){let de=Wt.get(R),tn=Wt.get(W);wt.bindFramebuffer(V.READ_FRAMEBUFFER,I),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,O);for(let Gn=0;Gn<Dt;Gn++)qi?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,de.__webglTexture,j,pe+Gn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,de.__webglTexture,j),us?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,tn.__webglTexture,Tt,Je+Gn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,tn.__webglTexture,Tt),j!==0?V.blitFramebuffer(Gt,ne,Gt+Lt,ne+At,Vt,me,Vt+Lt,me+At,V.COLOR_BUFFER_BIT,V.NEAREST):us?V.copyTexSubImage3D(Bt,Tt,Vt,me,Je+Gn,Gt,ne,Lt,At):V.copyTexSubImage2D(Bt,Tt,Vt,me,Gt,ne,Lt,At);wt.bindFramebuffer(V.READ_FRAMEBUFFER,null),wt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else us?R.isDataTexture||R.isData3DTexture?V.texSubImage3D(Bt,Tt,Vt,me,Je,Lt,At,Dt,Ne,gn,De.data):W.isCompressedArrayTexture?V.compressedTexSubImage3D(Bt,Tt,Vt,me,Je,Lt,At,Dt,Ne,De.data):V.texSubImage3D(Bt,Tt,Vt,me,Je,Lt,At,Dt,Ne,gn,De):R.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Tt,Vt,me,Lt,At,Ne,gn,De.data):R.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Tt,Vt,me,De.width,De.height,Ne,De.data):V.texSubImage2D(V.TEXTURE_2D,Tt,Vt,me,Lt,At,Ne,gn,De);wt.pixelStorei(V.UNPACK_ROW_LENGTH,an),wt.pixelStorei(V.UNPACK_IMAGE_HEIGHT,_e),wt.pixelStorei(V.UNPACK_SKIP_PIXELS,hs),wt.pixelStorei(V.UNPACK_SKIP_ROWS,ln),wt.pixelStorei(V.UNPACK_SKIP_IMAGES,zr),Tt===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&V.generateMipmap(Bt),wt.unbindTexture()},this.initRenderTarget=function(R){Wt.get(R).__webglFramebuffer===void 0&&Zt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Zt.setTextureCube(R,0):R.isData3DTexture?Zt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Zt.setTexture2DArray(R,0):Zt.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){H=0,z=0,Q=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var i_=new _i,Oh=new q,ko=class extends Va{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Ve(t,3)),this.setAttribute("uv",new Ve(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ks(e,6,1);return this.setAttribute("instanceStart",new zi(i,3,0)),this.setAttribute("instanceEnd",new zi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new Ks(e,6,1);return this.setAttribute("instanceColorStart",new zi(i,3,0)),this.setAttribute("instanceColorEnd",new zi(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Da(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _i);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),i_.setFromBufferAttribute(e),this.boundingBox.union(i_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Oh.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Oh)),Oh.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Oh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Kt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ei.line={uniforms:tl.merge([It.common,It.fog,It.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var sr=class extends Ei{constructor(t){super({type:"LineMaterial",uniforms:tl.clone(ei.line.uniforms),vertexShader:ei.line.vertexShader,fragmentShader:ei.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Mf=new Le,s_=new q,r_=new q,Ln=new Le,Dn=new Le,rs=new Le,bf=new q,wf=new Fe,Nn=new Ga,o_=new q,Bh=new _i,zh=new Bi,os=new Le,as,Dr;function a_(n,t,e){return os.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),os.multiplyScalar(1/os.w),os.x=Dr/e.width,os.y=Dr/e.height,os.applyMatrix4(n.projectionMatrixInverse),os.multiplyScalar(1/os.w),Math.abs(Math.max(os.x,os.y))}function nE(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,c=o;a<c;a++){Nn.start.fromBufferAttribute(s,a),Nn.end.fromBufferAttribute(r,a),Nn.applyMatrix4(e);let l=new q,h=new q;as.distanceSqToSegment(Nn.start,Nn.end,h,l),h.distanceTo(l)<Dr*.5&&t.push({point:h,pointOnLine:l,distance:as.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function iE(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,c=a.attributes.instanceStart,l=a.attributes.instanceEnd,h=Math.min(a.instanceCount,c.count),d=-t.near;as.at(1,rs),rs.w=1,rs.applyMatrix4(t.matrixWorldInverse),rs.applyMatrix4(i),rs.multiplyScalar(1/rs.w),rs.x*=r.x/2,rs.y*=r.y/2,rs.z=0,bf.copy(rs),wf.multiplyMatrices(t.matrixWorldInverse,o);for(let u=0,m=h;u<m;u++){if(Ln.fromBufferAttribute(c,u),Dn.fromBufferAttribute(l,u),Ln.w=1,Dn.w=1,Ln.applyMatrix4(wf),Dn.applyMatrix4(wf),Ln.z>d&&Dn.z>d)continue;if(Ln.z>d){let P=Ln.z-Dn.z,S=(Ln.z-d)/P;Ln.lerp(Dn,S)}else if(Dn.z>d){let P=Dn.z-Ln.z,S=(Dn.z-d)/P;Dn.lerp(Ln,S)}Ln.applyMatrix4(i),Dn.applyMatrix4(i),Ln.multiplyScalar(1/Ln.w),Dn.multiplyScalar(1/Dn.w),Ln.x*=r.x/2,Ln.y*=r.y/2,Dn.x*=r.x/2,Dn.y*=r.y/2,Nn.start.copy(Ln),Nn.start.z=0,Nn.end.copy(Dn),Nn.end.z=0;let x=Nn.closestPointToPointParameter(bf,!0);Nn.at(x,o_);let p=Qa.lerp(Ln.z,Dn.z,x),f=p>=-1&&p<=1,M=bf.distanceTo(o_)<Dr*.5;if(f&&M){Nn.start.fromBufferAttribute(c,u),Nn.end.fromBufferAttribute(l,u),Nn.start.applyMatrix4(o),Nn.end.applyMatrix4(o);let P=new q,S=new q;as.distanceSqToSegment(Nn.start,Nn.end,S,P),e.push({point:S,pointOnLine:P,distance:as.origin.distanceTo(S),object:n,face:null,faceIndex:u,uv:null,uv1:null})}}}var kh=class extends zn{constructor(t=new ko,e=new sr({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,c=e.count;o<c;o++,a+=2)s_.fromBufferAttribute(e,o),r_.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+s_.distanceTo(r_);let r=new Ks(s,2,1);return t.setAttribute("instanceDistanceStart",new zi(r,1,0)),t.setAttribute("instanceDistanceEnd",new zi(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;as=t.ray;let o=this.matrixWorld,a=this.geometry,c=this.material;Dr=c.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),zh.copy(a.boundingSphere).applyMatrix4(o);let l;if(i)l=Dr*.5;else{let d=Math.max(s.near,zh.distanceToPoint(as.origin));l=a_(s,d,c.resolution)}if(zh.radius+=l,as.intersectsSphere(zh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Bh.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=Dr*.5;else{let d=Math.max(s.near,Bh.distanceToPoint(as.origin));h=a_(s,d,c.resolution)}Bh.expandByScalar(h),as.intersectsBox(Bh)!==!1&&(i?nE(this,e):iE(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Mf),this.material.uniforms.resolution.value.set(Mf.z,Mf.w))}};var Nr=class extends ko{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setPositions(i),this}setColors(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setColors(i),this}setFromPoints(t){let e=t.length-1,i=new Float32Array(6*e);for(let s=0;s<e;s++)i[6*s]=t[s].x,i[6*s+1]=t[s].y,i[6*s+2]=t[s].z||0,i[6*s+3]=t[s+1].x,i[6*s+4]=t[s+1].y,i[6*s+5]=t[s+1].z||0;return super.setPositions(i),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Vh=class extends kh{constructor(t=new Nr,e=new sr({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var sE=new q(0,1,0),rE=new Po(1,1,1,40),oE=new La(1,32,20),aE=new $s(1,1,1),lE=new Ia(1,1,24);function rr(n){return new Io({color:n,roughness:.55,metalness:.08})}function Gh(n,t,e=!0){let i=new zn(n,t);return i.castShadow=e,i.receiveShadow=e,i}var Rs=(n,t)=>Gh(rE,n,t),rl=n=>Gh(oE,n),Hh=n=>Gh(aE,n),l_=n=>Gh(lE,n,!1);function or(n,t,e,i){let s=qe(e,t),r=Fn(s);n.visible=r>1e-9,n.visible&&(n.position.set(...Ht(t,Pt(s,.5))),n.quaternion.setFromUnitVectors(sE,new q(...Pt(s,1/r))),n.scale.set(i,r,i))}function ol(n,t,e,i,s){let r=Pt(e,i/2);or(n,qe(t,r),Ht(t,r),s)}function Wh(n,t,e,[i,s,r]){n.position.set(...t);let o=[...e.x,0,...e.y,0,...e.z,0,0,0,0,1];n.quaternion.setFromRotationMatrix(new Fe().fromArray(o)),n.scale.set(i,s,r)}function Vo(n,t,e=!1){let i=new Vh(new Nr,new sr({color:n,linewidth:t}));return i.frustumCulled=!1,e&&(i.material.depthTest=!1,i.material.transparent=!0,i.renderOrder=2),i}function Xh(n,t){n.visible=t.length>1,n.visible&&(n.geometry.dispose(),n.geometry=new Nr,n.geometry.setPositions(t.flat()))}function c_(){let n=document.createElement("canvas");[n.width,n.height]=[8,4];let t=n.getContext("2d");for(let i=0;i<4;i++)for(let s=0;s<2;s++)t.fillStyle=(i+s)%2===0?"#111418":"#ffffff",t.fillRect(2*i,2*s,2,2);let e=new Ra(n);return e.colorSpace=$n,e.magFilter=pn,new Io({map:e,roughness:.6})}function h_(n,t){let{x:e,y:i,z:s,half:r}=xl(t);return{x:Us(n,e),y:Us(n,i),z:Us(n,s),o:fr(n,t.com),half:r}}function u_(){let n=rr("#5c6673");Object.assign(n,{transparent:!0,opacity:.5,depthWrite:!1});let t=Hh(n);return{mesh:t,put(e,i){let{half:s,...r}=h_(e,i),o=Math.max(...s);Wh(t,r.o,r,s.map(a=>2*Math.max(a,.02*o))),t.visible=o>0}}}function d_(n,t){let{x:e,y:i,z:s,o:r,half:o}=h_(n,t),a=[e,i,s].map((c,l)=>Pt(c,o[l]));return[-1,1].flatMap(c=>[-1,1].flatMap(l=>[-1,1].map(h=>Ht(r,Ht(Ht(Pt(a[0],c),Pt(a[1],l)),Pt(a[2],h))))))}var cE=["#e03131","#2f9e44","#1c7ed6"];function hE(){let n=new Jn,t=cE.map(i=>{let s=rr(i),[r,o]=[Rs(s,!1),l_(s)];return n.add(r,o),{rod:r,head:o}});return{group:n,put:(i,s)=>{[i.x,i.y,i.z].forEach((r,o)=>{let[a,c]=[.78,1].map(l=>Ht(i.o,Pt(r,l*s)));or(t[o].rod,i.o,a,.032*s),or(t[o].head,a,c,.085*s)})}}}function ar(n){let t=n.rows.map((e,i)=>({row:e,index:i}));return n.isMounted?t.filter(({row:e})=>e.mount!==null):t}function f_(n,t,e){let i=ar(t),s=.034*e/Math.sqrt(Math.max(1,i.length/6)),r=_=>s*(1-.45*_/Math.max(i.length,4)),o=rr("#c9d1db"),a=rr("#5c6673"),c=new Jn;n.scene.add(c);let l=(_,v=c)=>(v.add(_),_),h=t.floating?null:{disc:l(Rs(a)),post:l(Rs(a))},d=t.floating&&u_();d&&l(d.mesh);let u=i.map(({row:_})=>{let v=rr("#888888");return{color:v,body:_.isPlace?null:l(_.type==="prismatic"?Hh(v):Rs(v)),caps:_.isPlace||_.type==="prismatic"?[]:[0,1].map(()=>l(Rs(a))),rods:[0,1].map(()=>l(Rs(o))),corners:[0,1].map(()=>l(rl(o)))}}),m=t.tips.map(()=>({rod:l(Rs(o)),ball:l(rl(a)),stub:l(Rs(o))})),g=l(new Jn),x=[...i,"base","world",...t.tips].map(()=>{let _=hE();return g.add(_.group),_}),p=l(new Jn),f=i.map(({row:_})=>{let v=Vo("#888888",1.6);return v.material.dashed=!0,p.add(v),v.visible=!_.isPlace,v}),M=l(new Jn),P=c_(),S=[...t.rows,...t.tips,...t.floating?[t.floating]:[]].map(()=>l(rl(P),M)),C=l(rl(rr("#f08c00")),M);function E(_,v,L){let{row:T,index:b}=i[v],{middle:D,frame:F,link:I,origin:O,axis:H,before:z}=_.rows[b],{body:Q,caps:Y,rods:Z,corners:nt}=u[v],lt=r(v),ht=t.isMounted?I.o:D.o,tt=t.isMounted?I.o:F.o;if(or(Z[0],L,ht,.52*lt),or(Z[1],ht,tt,.52*lt),[ht,tt].forEach((mt,_t)=>{nt[_t].position.set(...mt),nt[_t].scale.setScalar(.52*lt)}),!Q)return tt;if(T.type==="prismatic"){let mt=t.convention==="standard"?z:D;Wh(Q,t.isMounted?L:O,{...mt,z:H},[1.7*lt,1.7*lt,3.4*lt])}else{let mt=t.isMounted?I.o:t.convention==="standard"?O:F.o;ol(Q,mt,H,2.5*lt,lt),Y.forEach((_t,ot)=>{ol(_t,Ht(mt,Pt(H,(ot===0?1.3:-1.3)*lt)),H,.12*lt,.5*lt)})}return tt}return{paint(_){u.forEach(({color:v},L)=>{v.color.set(_(i[L].row)),f[L].material.color.set(_(i[L].row))}),n.ask()},show({frames:_,axes:v,masses:L}){g.visible=_,p.visible=v,M.visible=L,o.transparent=L,o.opacity=L?.45:1,n.ask()},put(_,v){let L=r(0),T=_.base.o;d?.put(_.base,v.floating),h&&ol(h.disc,qe(T,Pt(_.base.z,1.75*L)),_.base.z,.9*L,1.9*L),h&&ol(h.post,qe(T,Pt(_.base.z,1.1*L)),_.base.z,.6*L,1.25*L);let b=new Map([[null,T]]);i.forEach(({row:Q,index:Y},Z)=>b.set(Y,E(_,Z,b.get(Q.on)??T)));let D=r(i.length);m.forEach((Q,Y)=>{let{on:Z}=v.tips[Y],[nt,lt]=[b.get(Z)??T,_.tips[Y].o];or(Q.rod,nt,lt,.45*D),Q.ball.position.set(...lt),Q.ball.scale.setScalar(.62*D);let ht=Z===null?_.base:_.rows[Z].link,tt=Z!==null&&v.convention==="modified"&&Fs(nt,lt)<.01*e;or(Q.stub,ht.o,tt?fr(ht,v.rows[Z].com):ht.o,.45*D)});let F=.13*e;i.forEach(({index:Q},Y)=>x[Y].put(_.rows[Q].link,F)),x[i.length].put(_.base,1.15*F),x[i.length+1].put({x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]},1.5*F),_.tips.forEach((Q,Y)=>x[i.length+2+Y].put(Q,F)),i.forEach(({row:Q,index:Y},Z)=>{if(Q.isPlace)return;let{origin:nt,axis:lt,link:ht}=_.rows[Y],tt=t.isMounted?ht.o:nt;Xh(f[Z],[-.16,.16].map(mt=>Ht(tt,Pt(lt,mt*e))))});let[I,O]=[0,[0,0,0]],H=v.rows.map((Q,Y)=>({...Q,frame:_.rows[Y].link}));v.tips.forEach(({on:Q,body:Y},Z)=>H.push({...Q===null&&!v.floating?null:Y,frame:_.tips[Z]})),v.floating&&H.push({...v.floating,frame:_.base}),S.forEach((Q,Y)=>{let Z=H[Y];if(Q.visible=Z.mass>0,!Q.visible)return;let nt=fr(Z.frame,Z.com);Q.position.set(...nt),I+=Z.mass,O=Ht(O,Pt(nt,Z.mass))});let z=Math.max(...H.map(Q=>Q.mass??0));S.forEach((Q,Y)=>{Q.visible&&Q.scale.setScalar(.034*e*Math.cbrt(H[Y].mass/z))}),C.visible=I>0,I>0&&C.position.set(...Pt(O,1/I)),C.scale.setScalar(.02*e),n.ask()}}}function Ef(n,t,e){let i=[t.base.o,...t.tips.map(r=>r.o)];for(let{index:r}of ar(n)){let{middle:o,link:a}=t.rows[r];i.push(a.o),n.isMounted||i.push(o.o)}n.floating&&i.push(...d_(t.base,n.floating));for(let{on:r}of n.tips)r!==null&&i.push(fr(t.rows[r].link,n.rows[r].com));let s=.05*e;return i.flatMap(r=>[r,...[0,1,2].flatMap(o=>[-s,s].map(a=>r.map((c,l)=>l===o?c+a:c)))])}var lr={theta:"#e64980",d:"#228be6",a:"#37b24d",alpha:"#f76707"},p_={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},g_="#868e96";function m_(n,t,e,i,s){let r=Math.max(2,Math.ceil(Math.abs(i)/.06)),o=Pt(ni(qe(e,Pt(t,Ci(t,e)))),s);return Array.from({length:r+1},(a,c)=>Ht(n,jo(o,t,i*c/r)))}function uE(n,t){let e=n[n.length-1],i=ni(qe(e,n[n.length-2])),s=ni(Cn(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0]));return[1,-1].map(r=>Ht(e,Ht(Pt(i,-t),Pt(s,.4*r*t))))}function dE(n,t,e,i,s){let r=n.rows[e],{before:o,middle:a,frame:c,theta:l,d:h}=t.rows[e],d=n.convention==="standard",u=.115*s,m=e+1,g={paths:[],texts:[]},x=(T,b,D,F)=>{g.paths.push({color:lr[T],path:b,width:3.2});let[I,O]=uE(b,.03*s),H=b[b.length-1];g.paths.push({color:lr[T],path:[I,H,O],width:3.2});let z=!d&&(T==="a"||T==="alpha")?m-1:m;g.texts.push({at:D,name:T,sign:p_[T],index:z,text:F})},p=(T,b)=>g.paths.push({color:g_,path:[T,b],width:1.4}),f=T=>T[Math.floor(T.length/2)],[M,P]=d?[o,a]:[a,c],[S,C]=d?[a,c]:[o,a],E=d?M.o:P.o,_=d?C.o:S.o,v=T=>Math.abs(T)<1e-9,L=M.z;for(let T of[M.x,P.x])p(E,Ht(E,Pt(T,1.25*u)));if(v(l))g.texts.push({at:Ht(E,Pt(P.x,1.3*u)),name:"theta",sign:p_.theta,index:m,text:i.angle(0)});else{let T=m_(E,L,M.x,l,u),b=ni(qe(f(T),E));x("theta",T,Ht(E,Pt(b,1.2*u)),i.angle(l))}if(Math.abs(h)>1e-9&&x("d",[M.o,P.o],Pt(Ht(M.o,P.o),.5),i.length(h)),Math.abs(r.a)>1e-9&&x("a",[S.o,C.o],Pt(Ht(S.o,C.o),.5),i.length(r.a)),!v(r.alpha)){for(let D of[S.z,C.z])p(_,Ht(_,Pt(D,1.25*u)));let T=m_(_,S.x,S.z,r.alpha,u),b=ni(qe(f(T),_));x("alpha",T,Ht(_,Pt(b,1.2*u)),i.angle(r.alpha))}return g}function fE(n,t,e,i,s,r){let{link:o,axis:a}=t.rows[e],c={paths:[],texts:[]},l=[i.o,o.o];if(Fs(...l)>1e-9){c.paths.push({color:lr.a,path:l,width:3.2});let d=qe(o.o,i.o),u=[i.x,i.y,i.z].map(m=>s.number(Ci(m,d)));c.texts.push({at:Pt(Ht(...l),.5),name:"a",sign:"xyz",index:null,text:`${u.join(", ")} m`})}let h=Ht(o.o,Pt(a,.2*r));return c.paths.push({color:lr.theta,path:[o.o,h],width:3.2}),c.texts.push({at:h,name:"theta",sign:"axis",index:null,text:""}),c}function __(n,t,e){let i=new Jn;n.scene.add(i);let s=[],r=ar(t);return{put(o,a,c,l){let h=c.map(u=>{if(!t.isMounted)return dE(a,o,u,l,e);let m=r.findIndex(x=>x.index===u),g=m>0?o.rows[r[m-1].index].link:o.base;return fE(a,o,u,g,l,e)}),d=h.flatMap(({paths:u})=>u);for(;s.length<d.length;){let u=Vo(g_,1,!0);i.add(u),s.push(u)}return s.forEach((u,m)=>{u.visible=m<d.length,u.visible&&(Xh(u,d[m].path),u.material.color.set(d[m].color),u.material.linewidth=d[m].width)}),n.ask(),h.flatMap(({texts:u})=>u)}}}var al=2;function x_(n,t){let e=[],i=[];function s(){let r=[],{clientWidth:o,clientHeight:a}=t;e.forEach(({at:c},l)=>{let h=i[l],d=n.onCanvas(c);if(h.hidden=d===null,!d)return;let[u,m]=[h.offsetWidth,h.offsetHeight],g=Math.min(Math.max(d[0]-u/2,2),o-u-2),x=Math.min(Math.max(d[1]-m/2,2),a-m-2);for(let p=0;p<12;p++){let f=r.find(M=>!(g>M.x+M.wide+al||M.x>g+u+al)&&x<M.y+M.high+al&&M.y<x+m+al);if(!f)break;x=f.y+f.high+al+.5}r.push({x:g,y:x,wide:u,high:m}),h.style.transform=`translate(${g}px, ${x}px)`})}return n.onDraw(s),{put(r){for(e=r;i.length<r.length;)i.push(t.appendChild(G("span")));i.forEach((o,a)=>{if(o.hidden=a>=r.length,o.hidden)return;let{content:c,kind:l,color:h}=r[a];o.className=`label ${l}`,o.style.setProperty("--color",h),o.replaceChildren(...[c].flat())}),n.ask()}}}var y_={type:"change"},Af={type:"start"},S_={type:"end"},qh=new Tr,v_=new mi,pE=Math.cos(70*Qa.DEG2RAD),Sn=new q,ri=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Tf=1e-6,Yh=class extends Wa{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Qs.ROTATE,MIDDLE:Qs.DOLLY,RIGHT:Qs.PAN},this.touches={ONE:tr.ROTATE,TWO:tr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new Kn,this._lastTargetPosition=new q,this._quat=new Kn().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Do,this._sphericalDelta=new Do,this._scale=1,this._panOffset=new q,this._rotateStart=new Kt,this._rotateEnd=new Kt,this._rotateDelta=new Kt,this._panStart=new Kt,this._panEnd=new Kt,this._panDelta=new Kt,this._dollyStart=new Kt,this._dollyEnd=new Kt,this._dollyDelta=new Kt,this._dollyDirection=new q,this._mouse=new Kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=gE.bind(this),this._onPointerDown=mE.bind(this),this._onPointerUp=_E.bind(this),this._onContextMenu=wE.bind(this),this._onMouseWheel=vE.bind(this),this._onKeyDown=SE.bind(this),this._onTouchStart=ME.bind(this),this._onTouchMove=bE.bind(this),this._onMouseDown=xE.bind(this),this._onMouseMove=yE.bind(this),this._interceptControlDown=EE.bind(this),this._interceptControlUp=TE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(y_),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ri:i>Math.PI&&(i-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new q(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(qh.origin.copy(this.object.position),qh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(qh.direction))<pE?this.object.lookAt(this.target):(v_.setFromNormalAndCoplanarPoint(this.object.up,this.target),qh.intersectPlane(v_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Tf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Tf||this._lastTargetPosition.distanceToSquared(this.target)>Tf?(this.dispatchEvent(y_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ri/60*this.autoRotateSpeed*t:ri/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/e.clientHeight),this._rotateUp(ri*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/e.clientHeight),this._rotateUp(ri*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function mE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function gE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function _E(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(S_),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function xE(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Re.DOLLY;break;case Qs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Re.ROTATE}break;case Qs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Af)}function yE(n){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function vE(n){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(n.preventDefault(),this.dispatchEvent(Af),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(S_))}function SE(n){this.enabled!==!1&&this._handleKeyDown(n)}function ME(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case tr.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(n),this.state=Re.TOUCH_ROTATE;break;case tr.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(n),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case tr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Re.TOUCH_DOLLY_PAN;break;case tr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Af)}function bE(n){switch(this._trackPointer(n),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Re.NONE}}function wE(n){this.enabled!==!1&&n.preventDefault()}function EE(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function TE(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Rf(n){let t=Math.abs(n[0])<.9?[1,0,0]:[0,1,0],e=ni(qe(t,Pt(n,Ci(t,n))));return[e,Cn(n,e)]}function M_(n,t,e){let i;try{i=new Nh({canvas:n,antialias:!0,alpha:!0})}catch{return null}i.shadowMap.enabled=!0;let s=new ba,r=new Zn(32,1,e/100,e*60);r.up.set(...t);let o=new Yh(r,n);o.enableDamping=!1,o.minDistance=e/10,o.maxDistance=e*20;let a=new Oa(16777215,9279912,1.6);a.position.set(...t);let[c,l]=Rf(t),h=new ka(16777215,2.2),d=Ht(Ht(Pt(t,2.2),Pt(c,.9)),Pt(l,-1.1));h.castShadow=!0,h.shadow.mapSize.set(1024,1024),h.shadow.radius=5,h.shadow.bias=-5e-4,h.shadow.normalBias=e/200,Object.assign(h.shadow.camera,{left:-1.6*e,right:1.6*e,top:1.6*e,bottom:-1.6*e,near:.1*e,far:8*e}),s.add(a,h,h.target);let u=new Kn().setFromUnitVectors(new q(0,0,1),new q(...t)),m=new zn(new Ar(12*e,12*e),new Na({opacity:.16}));m.quaternion.copy(u),m.receiveShadow=!0,s.add(m);let g=null,x=!1,p=[],f=()=>{x=!1,i.render(s,r),p.forEach(S=>S())},M=()=>{x||requestAnimationFrame(f),x=!0};o.addEventListener("change",M);let P=()=>{let{clientWidth:S,clientHeight:C}=n;S===0||C===0||(i.setPixelRatio(Math.min(devicePixelRatio,2)),i.setSize(S,C,!1),r.aspect=S/C,r.updateProjectionMatrix(),M())};return new ResizeObserver(P).observe(n),{scene:s,camera:r,canvas:n,ask:M,onDraw:S=>p.push(S),ground(S,C,E,_=!0){m.visible=_;let v=Ht(S,Pt(t,C-Ci(S,t)));m.position.set(...v),h.target.position.set(...S),h.position.set(...Ht(S,Pt(ni(d),4*e))),g&&s.remove(g);let L=10**Math.floor(Math.log10(e/2)),T=[1,2,5,10].map(D=>D*L).find(D=>D>=e/8),b=2*Math.ceil(2*e/T);return g=new Ha(b*T,b,new he(E[0]),new he(E[1])),g.quaternion.setFromUnitVectors(new q(0,1,0),new q(...t)),g.position.set(...Ht(v,Pt(t,-e/500))),s.add(g),M(),T},look(S,C){P();let _=[0,1,2].map(D=>C.map(F=>F[D])).map(D=>(Math.min(...D)+Math.max(...D))/2),v=Math.max(...C.map(D=>Fn(qe(D,_))),e/8),L=r.fov*Math.PI/360,T=Math.min(L,Math.atan(Math.tan(L)*r.aspect)),b=1.12*v/Math.sin(T);r.position.set(...Ht(_,Pt(ni(S),b))),o.target.set(..._),o.update(),M()},follow(S){for(let{position:C}of[r,h,h.target])C.set(...Ht(C.toArray(),S));o.target.set(...Ht(o.target.toArray(),S)),o.update(),M()},turn(S,C){let E=o.target.toArray(),_=qe(r.position.toArray(),E),v=ni(Cn(t,_)),L=jo(jo(_,t,S),v,-C);Fn(Cn(ni(L),t))<.05||(r.position.set(...Ht(E,L)),o.update(),M())},zoom(S){let C=o.target.toArray(),E=qe(r.position.toArray(),C);r.position.set(...Ht(C,Pt(E,S))),o.update(),M()},onCanvas(S){let C=new q(...S).project(r);if(C.z>1)return null;let{clientWidth:E,clientHeight:_}=n;return[(C.x+1)/2*E,(1-C.y)/2*_]}}}var AE=[.1,.25,.5,1,2],b_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z"};function RE(n){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidden","true");let e=document.createElementNS("http://www.w3.org/2000/svg","path");return e.setAttribute("d",n),t.append(e),t}function w_(n){let{state:t}=n,e=G("button",{type:"button",class:"play","data-key":"play"}),i=G("input",{type:"range",min:0,step:"any","data-key":"time","aria-label":"Time"}),s=G("output",{class:"time","data-key":"seconds"}),r=G("select",{"aria-label":"Speed","data-key":"speed"},AE.map(u=>G("option",{value:u,selected:u===1},`${u}\xD7`))),o=G("input",{type:"checkbox","data-key":"repeat"}),a=null;function c(u){if(!t.isPlaying){a=null;return}if(a!==null){let{duration:m}=n.trajectory,g=t.t+(u-a)/1e3*t.speed;g>=m&&o.checked&&m>0&&(g%=m),g>=m&&n.play(!1),n.setTime(g)}a=u,requestAnimationFrame(c)}function l(){e.replaceChildren(RE(t.isPlaying?b_.pause:b_.play)),e.setAttribute("aria-label",t.isPlaying?"Pause":"Play"),t.isPlaying&&a===null&&requestAnimationFrame(c)}function h(){let{duration:u}=n.trajectory??{duration:0};i.max=u,i.value=t.t;let m=`${t.t.toFixed(2)} / ${u.toFixed(2)} s`;i.setAttribute("aria-valuetext",m),s.textContent=m,d.hidden=n.trajectory===null}e.addEventListener("click",()=>n.play(!t.isPlaying)),i.addEventListener("input",()=>{n.play(!1),n.setTime(Number(i.value))}),r.addEventListener("change",()=>t.speed=Number(r.value));let d=G("div",{class:"transport",role:"group","aria-label":"Time"},e,i,s,r,G("label",{class:"check"},o,"repeat"));return n.on("play",l),n.on("time trajectory",h),l(),h(),d}function CE(n){return Fn(n.gravity)>1e-9?ni(Pt(n.gravity,-1)):[0,0,1]}function PE(n,t){if(n.floating)return null;let{rows:e}=Bs(n,new Array(n.joints).fill(0),null),i=n.rows.flatMap((o,a)=>o.type==="revolute"&&o.joint!==null?[e[a].axis]:[]);if(i.length===0)return null;let[s]=i;return i.every(o=>Fn(Cn(s,o))<1e-6)&&Math.abs(Ci(s,t))<1e-6?s:null}function E_(n){let{table:t,state:e,size:i}=n,s=G("canvas",{tabIndex:0,role:"img"}),r=G("div",{class:"labels","aria-hidden":"true"}),o=G("output",{class:"readout"}),a=G("span",{class:"scale"}),c=G("div",{class:"views",role:"group","aria-label":"View"}),l=G("div",{class:"shown",role:"group","aria-label":"What is shown"}),h=G("div",{class:"view"},s,r,c,o,a),d=G("section",{class:"panel stage","aria-label":"The arm"},h,l,w_(n));s.setAttribute("aria-label",`${t.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);function u(){let p=CE(t),f=M_(s,p,i);if(!f){h.classList.add("missing"),h.append(G("p",{},"This browser draws no WebGL: the arm is not shown. All numbers are."));return}let M=f_(f,t,i),P=__(f,t,i),S=x_(f,r),C=ar(t),E=Vo("#f08c00",2.4);E.visible=!1,f.scene.add(E);let _=PE(t,p),[v,L]=Rf(p),T=_??Pt(L,-1),b=Cn(p,T),F={"3D":_?Ht(Ht(T,Pt(b,.22)),Pt(p,.16)):Ht(Ht(Pt(v,.75),Pt(L,-.9)),Pt(p,.55)),front:Ht(T,Pt(p,1e-4)),side:Ht(b,Pt(p,1e-4)),top:Ht(p,Pt(T,.001))},I="3D";function O(ot,dt,Nt){let $t=Bs(n.table,dt,ot),Ot=Y()?qe(Nt,$t.base.o):[0,0,0];return Ef(n.table,$t,i).map(se=>Ht(se,Ot))}function H(ot){I=ot;let dt=n.trajectory??{q:[],base:[]},Nt=Math.max(1,Math.floor(dt.q.length/12)),$t=n.frames().base.o,Ot=dt.q.flatMap((Xt,Se)=>Se%Nt===0||Se===dt.q.length-1?O(dt.base[Se],Xt,$t):[]).concat(O(n.start(),e.q,$t)).filter(Xt=>Fs(Xt,$t)<1.6*i);Q=$t;let se=Bs(n.table,e.q,n.start()),ae=t.floating?Ef(n.table,se,i):Ot;z=Math.min(...ae.map(Xt=>Ci(Xt,p)),Ci(se.base.o,p)-.09*i),nt(),f.look(F[ot],Ot.length>0?Ot:[$t])}let z=0,Q=[0,0,0],Y=()=>t.floating!==null&&e.mode==="free"&&e.show.isFollowed;function Z(ot){Y()&&f.follow(qe(ot,Q)),Q=ot}function nt(){let{base:ot}=Bs(n.table,e.q,n.start()),dt=t.floating!==null&&e.mode==="free",Nt=f.ground(ot.o,z,[Sr("--grid-strong"),Sr("--grid")],!dt);a.textContent=`grid ${Nt>=1?Nt:Number(Nt.toPrecision(3))} m`}for(let ot of Object.keys(F))c.append(G("button",{type:"button",class:"chip","data-key":`view-${ot}`,onclick:()=>H(ot)},ot));s.addEventListener("keydown",({key:ot})=>{let dt={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};dt[ot]&&f.turn(...dt[ot]),(ot==="+"||ot==="-")&&f.zoom(ot==="+"?.9:1/.9)});function lt(){let{parameters:ot}=e.show;if(ot==="none")return[];let dt=C.filter(({row:Nt})=>!Nt.isPlace).map(({index:Nt})=>Nt);return ot==="all"?dt:dt.filter(Nt=>Nt===e.selected)}function ht(){let ot=n.frames();Z(ot.base.o),M.put(ot,n.table);let dt=P.put(ot,n.table,lt(),n.units),Nt=e.show.frames?[{at:ot.base.o,content:"0",kind:"frame",color:"var(--ink)"},...C.map(({row:Xt,index:Se},Ce)=>({at:ot.rows[Se].link.o,content:Xt.isPlace?"tip":String(Ce+1),kind:"frame",color:"var(--ink)"})),...(t.tips.length>1?t.tips:[]).map(({name:Xt},Se)=>({at:ot.tips[Se].o,content:Xt,kind:"frame",color:"var(--ink)"}))]:[],$t=dt.map(({at:Xt,name:Se,sign:Ce,index:je,text:Ee})=>({at:Xt,content:[...un(Ce,je),Ee?` = ${Ee}`:""],kind:"parameter",color:lr[Se]}));S.put([...Nt,...$t]);let[Ot,se,ae]=ot.tips[e.tip].o.map(Xt=>(Math.abs(Xt)<5e-7?0:Xt).toFixed(4));o.textContent=`${n.tip().name}  x ${Ot}  y ${se}  z ${ae} m`,mt()}function tt(){let{trajectory:ot}=n,dt=ot?.tip??[];E.visible=dt.length>1,E.visible&&(E.geometry.dispose(),E.geometry=new E.geometry.constructor,E.geometry.setPositions(dt.flat()),mt())}function mt(){let{trajectory:ot}=n;if(!ot||ot.t.length<2){E.visible=!1;return}let dt=Math.floor(e.t/ot.duration*(ot.t.length-1)+1e-9);E.visible=e.show.trace&&dt>0,E.geometry.instanceCount=dt,f.ask()}function _t(){let ot=dt=>dt.joint??dt.follows?.joint;M.paint(dt=>Sr(ot(dt)===void 0?"--muted":`--joint-${ot(dt)%8}`)),E.material.color.set(Sr("--trace")),nt()}n.on("time fields units selection tip",ht),n.on("trajectory",tt),n.on("show",()=>{M.show(e.show),ht()}),n.on("theme",_t),n.on("mode",()=>H(I)),M.show(e.show),H("3D"),_t(),ht(),tt(),requestAnimationFrame(()=>H("3D"))}let m=G("select",{"data-key":"parameters"},Object.entries({selected:"selected row",all:"all rows",none:"none"}).map(([p,f])=>G("option",{value:p},f)));m.addEventListener("change",()=>n.setShown({parameters:m.value}));let g=t.isMounted?"placement":"D-H parameters";if(l.append(G("label",{class:"choice"},G("span",{},g),m)),t.tips.length>1){let p=G("select",{"data-key":"tip"},t.tips.map(({name:f},M)=>G("option",{value:M},f)));p.addEventListener("change",()=>n.setTip(Number(p.value))),l.append(G("label",{class:"choice"},G("span",{},"frame"),p))}let x={frames:"frames",axes:"axes",masses:"masses",trace:"trace"};t.floating&&(x.isFollowed="follow the fall");for(let[p,f]of Object.entries(x)){let M=G("input",{type:"checkbox",checked:e.show[p],"data-key":`show-${p}`});M.addEventListener("change",()=>n.setShown({[p]:M.checked})),l.append(G("label",{class:"check"},M,f))}return{section:d,start:u}}var IE={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},LE={standard:["theta","d","a","alpha"],modified:["alpha","a","d","theta"]},cr=(n,t=4)=>n.map(e=>xe(e,t)).join(", ");function T_(n){let{table:t,state:e}=n,i=ar(t),s=t.isMounted?["xyz","rpy","axis"]:LE[t.convention],r=t.rows.some(v=>v.limits),o=t.rows.some(v=>v.gearRatio!==0&&v.motorInertia!==0),a=t.rows.some(v=>v.viscous||v.coulomb.some(Boolean)||v.stribeck||v.spring),c=G("input",{type:"checkbox","data-key":"bodies"}),l=G("thead"),h=G("tbody"),d=G("caption");function u(){let{angleUnit:v}=n.units,L=b=>t.convention==="modified"&&(b==="a"||b==="alpha"),T=s.map(b=>{if(t.isMounted){let O={xyz:"m",rpy:v,axis:""}[b];return G("th",{scope:"col"},b," ",G("span",{class:"unit"},O))}let D=G("span",{class:"swatch"});D.style.background=lr[b];let F=b==="a"||b==="d"?"m":v,I=un(IE[b],L(b)?"i\u22121":"i");return G("th",{scope:"col"},D,I," ",G("span",{class:"unit"},F))});r&&T.push(G("th",{scope:"col"},"limits")),T.push(G("th",{scope:"col"},"mass ",G("span",{class:"unit"},"kg"))),c.checked&&(T.push(G("th",{scope:"col"},"centre of mass ",G("span",{class:"unit"},"m"))),T.push(G("th",{scope:"col"},"inertia xx, yy, zz, xy, yz, xz ",G("span",{class:"unit"},"kg m\xB2"))),o&&T.push(G("th",{scope:"col"},"motor")),a&&T.push(G("th",{scope:"col"},"friction, spring"))),l.replaceChildren(G("tr",{},G("th",{scope:"col"},"joint"),T))}function m(v){if(v.joint!==null)return un("q",v.joint+1);if(!v.follows)return null;let{joint:L,factor:T,offset:b}=v.follows,D=T===1?"":T===-1?"-":`${xe(T)} `,F=b===0?"":` ${b<0?"-":"+"} ${xe(Math.abs(b))}`;return[D,...un("q",L+1),F]}function g(v,L){let{cell:T}=n.units;if(t.isMounted){let{places:z,axis:Q}=v.mount,Y=Kf(z),[Z,nt]=Q,lt=[Math.sin(nt)*Math.cos(Z),Math.sin(nt)*Math.sin(Z),Math.cos(nt)],ht={xyz:cr(Y.xyz),rpy:Y.rpy.map(T).join(", "),axis:cr(lt.map(tt=>Math.abs(tt)<1e-12?0:tt))};return G("td",{},L==="axis"&&v.isPlace?"":ht[L])}let b=L==="theta"||L==="alpha",D=b?T(v[L]):xe(v[L],6),F=v.text[L],I=L===(v.type==="prismatic"?"d":"theta"),O=I?m(v):null,H=F?[G("i",{},F),G("span",{class:"unit"},` = ${D}`)]:[D];if(O)return G("td",{class:"variable"},O,v[L]===0&&!F?null:[" + ",H]);if(I&&v.locked!==null&&!v.isPlace){let z=v[L]+v.locked;return G("td",{},b?T(z):xe(z,6)," ",G("span",{class:"kind"},"locked"))}return G("td",{},H)}function x(v){let{viscous:L,coulomb:T,stribeck:b,spring:D}=v,F=T[0]===T[1];return[L?`viscous ${xe(L)}`:null,T.some(Boolean)?`Coulomb ${F?xe(T[0]):`+${xe(T[0])} / -${xe(T[1])}`}`:null,b?`static ${xe(b.friction)} below ${xe(b.velocity)}`:null,D?`spring ${xe(D.stiffness)} at ${xe(D.rest)}`:null].filter(Boolean).join(", ")}let p=({xyz:v,rpy:L})=>`xyz ${cr(v)} m, rpy ${L.map(n.units.cell).join(", ")} ${n.units.angleUnit}`,f=v=>v===null?"the base":t.rows[v].name;function M(v,L){return v.follows?t.isMounted?["follows ",m(L)]:"follows":v.locked===null?v.type:t.isMounted?`locked at ${xe(L.locked*n.units.factor(v.type))} ${n.units.position(v.type)}`:"locked"}function P({row:v,index:L}){let T=n.table.rows[L],{factor:b,position:D}=n.units,F=v.joint??v.follows?.joint,I=G("th",{scope:"row"});if(v.isPlace)I.append("tip");else{let H=G("button",{type:"button",class:"name",onclick:()=>n.select(L)});H.append(G("span",{class:"dot"}),v.name||"fixed"," "),H.append(G("span",{class:"kind"},M(v,T))),(v.on??-1)!==L-1&&H.append(G("span",{class:"kind"},` on ${f(v.on)}`));let z=t.isMounted?[]:T.step.map(Q=>`, at ${p(Q)}`);H.append(G("span",{class:"kind"},...z)),I.append(H)}I.style.setProperty("--color",F===void 0?"var(--muted)":`var(--joint-${F%8})`);let O=s.map(H=>g(T,H));if(r){let H=b(v.type),z=T.limits?.map(Q=>xe(Q*H));O.push(G("td",{},z?`${z[0]} \u2026 ${z[1]} ${D(v.type)}`:""))}if(O.push(G("td",{},T.text.mass?[G("i",{},T.text.mass),` = ${xe(T.mass)}`]:xe(T.mass))),c.checked){O.push(G("td",{},cr(T.com)),G("td",{},cr(T.inertia)));let{motorInertia:H,gearRatio:z}=T;o&&O.push(G("td",{},H?`${xe(H)} kg m\xB2 \xD7 ${xe(z)}\xB2`:"")),a&&O.push(G("td",{},x(T)))}return G("tr",{"data-row":L},I,O)}function S(v,L,T){let b=[G("td",{colSpan:s.length+(r?1:0)},p(L)),G("td",{},T)];return c.checked&&b.push(G("td",{colSpan:4},L.com?cr(L.com):"")),G("tr",{class:"placed"},G("th",{scope:"row"},v),b)}function C({mass:v,com:L,inertia:T}){let b=[G("td",{colSpan:s.length+(r?1:0)},"moves freely"),G("td",{},xe(v))];return c.checked&&b.push(G("td",{},cr(L)),G("td",{},cr(T))),G("tr",{class:"placed"},G("th",{scope:"row"},"base"),b)}function E(){let{base:v,floating:L,tool:T}=n.table;u();let b=i.map(P);v&&b.unshift(S("base",v,"")),L&&b.unshift(C(L)),T&&b.push(S("tool",T,xe(T.mass)));for(let{name:D,on:F,places:I,body:O}of n.table.tips.filter(H=>H.isFrame&&H.places.length===1))b.push(S(`${D} on ${f(F)}`,{...I[0],com:O?.com},O?xe(O.mass):""));h.replaceChildren(...b),d.textContent=t.isMounted?"Joints as the file places them":`Denavit-Hartenberg table, ${t.convention} convention`,_()}function _(){for(let v of h.children)v.classList.toggle("selected",Number(v.dataset.row)===e.selected)}return c.addEventListener("change",E),n.on("fields units",E),n.on("selection",_),E(),G("section",{class:"panel table","aria-label":"Table"},fs("Table of the arm",G("table",{class:"cells"},d,l,h)),G("label",{class:"check"},c,"bodies, motors, friction"))}var Cf=["auto","light","dark"];function DE({floating:n,convention:t,isMounted:e,gravity:i},s){let r=s.map(({type:h})=>h==="revolute"?"R":"P").join(""),o=i.map(h=>xe(h)).join(", "),a=e?"joints of a URDF file":`${t} D-H table`,c=n?["a base that moves"]:[],l=s.length===0?[]:[`${s.length} ${s.length===1?"joint":"joints"} (${r})`,a];return[...c,...l,`gravity (${o}) m/s\xB2`].join(", ")}function NE(n){let t=G("button",{type:"button",class:"quiet","data-key":"theme"}),e=0,i=()=>{document.documentElement.dataset.theme=Cf[e],t.textContent=`Colors: ${Cf[e]}`};t.addEventListener("click",()=>{e=(e+1)%Cf.length,i(),n.tell("theme")}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n.tell("theme")),i();let s=G("button",{type:"button",class:"quiet","data-key":"units"}),r=()=>s.textContent=`Angles: ${n.units.inDegrees?"degrees":"radians"}`;return s.addEventListener("click",()=>n.setUnits(!n.units.inDegrees)),n.on("units",r),r(),G("header",{},G("div",{},G("h1",{},n.table.name),G("p",{class:"said"},DE(n.table,n.joints))),G("div",{class:"switches"},s,t))}var Ur=Np(globalThis.robotTable,globalThis.robotEquations,globalThis.robotStart),A_=E_(Ur),R_=lg(Ur);document.getElementById("page").append(NE(Ur),G("main",{},G("div",{class:"column fixed"},A_.section,T_(Ur)),G("div",{class:"column"},up(Ur),Up(Ur),R_.section)),G("footer",{},"M, V, G, \u03C4 and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units."));A_.start();R_.build();globalThis.robotPage=Ur;document.documentElement.dataset.ready="true";
